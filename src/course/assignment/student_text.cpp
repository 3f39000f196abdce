// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/assignment/student_text.hpp"

#include <algorithm>
#include <array>
#include <fstream>

#include "system/utf8.hpp"

namespace course {
namespace {

/// Whether a character changes the direction in which the characters after it are shown, so that a
/// text would look like another one.
bool turns_text(char32_t code) {
  return code == 0x061C || code == 0x200E || code == 0x200F || (code >= 0x202A && code <= 0x202E) ||
         (code >= 0x2066 && code <= 0x2069);
}

/// Whether a character may be shown: it is no control character but tab and line end, ends no line
/// but by these, does not turn the text, and is neither U+FFFE nor U+FFFF, which XML does not take.
bool is_shown(char32_t code) {
  if (code == '\n' || code == '\t') return true;
  const bool is_control = code < 0x20 || (code >= 0x7F && code < 0xA0);
  const bool ends_line = code == 0x2028 || code == 0x2029;
  return !is_control && !ends_line && !turns_text(code) && code != 0xFFFE && code != 0xFFFF;
}

}  // namespace

std::string shown(std::string_view text, std::size_t max_bytes) {
  std::string result;
  while (!text.empty()) {
    const auto [bytes, code_point] = sys::first_character(text);
    const std::string_view good = code_point && is_shown(*code_point) ? bytes : "?";
    if (result.size() + good.size() > max_bytes) return result + "\n[… cut]";
    result += good;
    text.remove_prefix(bytes.size());
  }
  return result;
}

std::string shown_name(std::string_view name) {
  std::string result = shown(name.substr(0, 200), 200);
  for (char& character : result) {
    if (character == '\n' || character == '\t') character = '?';
  }
  return name.size() > 200 ? result + "…" : result;
}

std::string beginning_of(const std::filesystem::path& file, std::size_t max_bytes) {
  std::ifstream stream(file, std::ios::binary);
  std::string text;
  std::array<char, 65536>
      chunk{};  // most files are small, and max_bytes is what a large one may be
  while (text.size() < max_bytes && stream) {
    const std::size_t most = std::min(chunk.size(), max_bytes - text.size());
    stream.read(chunk.data(), static_cast<std::streamsize>(most));
    text.append(chunk.data(), static_cast<std::size_t>(stream.gcount()));
  }
  return text;
}

}  // namespace course
