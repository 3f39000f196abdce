// SPDX-License-Identifier: GPL-3.0-or-later
// Characters and lines of a text, independent of the locale.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace sys {

/// These three functions know ASCII only.
constexpr bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

constexpr bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

constexpr bool is_alphanumeric(char c) {
  return is_letter(c) || is_digit(c);
}

/// Splits a text into lines without their ends "\n" or "\r\n". A final line end starts no line.
std::vector<std::string_view> lines_of(std::string_view text);

/// Removes blanks, tabs and line ends from both ends of a text.
std::string_view stripped(std::string_view text);

/// Returns the words of a text on one line, separated by single spaces.
std::string one_line(std::string_view text);

}  // namespace sys
