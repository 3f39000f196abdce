// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/document/last_registered.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <mutex>

namespace literate {
namespace {

struct KeptText {
  std::array<char, 400> characters{};
  std::size_t size = 0;
};

// One is read while the other is written.
std::array<KeptText, 2> kept_texts;
std::atomic<int> current_text = -1;

}  // namespace

void remember_last_registered(const std::string& what) {
  static std::mutex mutex;
  const std::lock_guard lock(mutex);
  const int next = current_text == 0 ? 1 : 0;
  KeptText& text = kept_texts.at(static_cast<std::size_t>(next));
  text.size = std::min(what.size(), text.characters.size());
  std::copy_n(what.begin(), text.size, text.characters.begin());
  current_text = next;
}

std::string_view last_registered() {
  const int i = current_text;
  if (i < 0) return "nothing";
  const KeptText& text = kept_texts[static_cast<std::size_t>(i)];
  return {text.characters.data(), text.size};
}

}  // namespace literate
