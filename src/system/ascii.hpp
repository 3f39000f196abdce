// SPDX-License-Identifier: GPL-3.0-or-later
// Kinds of ASCII characters, whatever the locale says.
#pragma once

namespace sys {

constexpr bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

constexpr bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

constexpr bool is_alphanumeric(char c) {
  return is_letter(c) || is_digit(c);
}

}  // namespace sys
