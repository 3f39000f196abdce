// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace literate {

/// Of ASCII.
constexpr bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}
constexpr bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

/// Of the name of a TeX command.
constexpr bool is_command_letter(char c) {
  return is_letter(c) || c == '@';
}

/// How many characters a UTF-8 text has.
int n_characters(std::string_view utf8);

/// The bytes of the first UTF-8 character of a text that is not empty; a byte that starts no
/// valid character stands alone.
std::string_view first_character(std::string_view text);

/// What LaTeX prints for a character beyond ASCII; empty if there is no mapping.
std::string_view latex_of(std::string_view character);

/// The mappings as a `literate` setting for the listings package.
std::string listings_characters();

}  // namespace literate
