// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/utf8.hpp"

#include <utf8.h>

namespace sys {

Utf8Character first_character(std::string_view text) {
  constexpr std::size_t longest = 4;
  const std::string_view head = text.substr(0, longest);
  if (utf8::find_invalid(head.begin(), head.end()) == head.begin()) {
    return {text.substr(0, 1), std::nullopt};
  }
  const char* end = head.data();
  const char32_t code_point = utf8::unchecked::next(end);
  return {text.substr(0, static_cast<std::size_t>(end - head.data())), code_point};
}

std::size_t n_characters(std::string_view text) {
  std::size_t n = 0;
  for (; !text.empty(); ++n) text.remove_prefix(first_character(text).bytes.size());
  return n;
}

}  // namespace sys
