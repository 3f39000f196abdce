// SPDX-License-Identifier: GPL-3.0-or-later
// The characters of a text, whatever the locale says, and its lines.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sys {

/// These three are of ASCII.
constexpr bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

constexpr bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

constexpr bool is_alphanumeric(char c) {
  return is_letter(c) || is_digit(c);
}

/// One character of a UTF-8 text.
struct Utf8Character {
  std::string_view bytes;
  std::optional<char32_t> code_point;  ///< none for a byte that belongs to no valid character
};

/// Returns the first character of a text, which must not be empty. If its first byte starts no
/// valid character, that byte alone; overlong forms and surrogates are not valid.
Utf8Character first_character(std::string_view text);

/// Counts the characters of a text; each byte that belongs to no valid character counts as one.
std::size_t n_characters(std::string_view text);

/// Splits a text into lines, without their ends "\n" or "\r\n". No line follows the last line end.
std::vector<std::string_view> lines_of(std::string_view text);

/// The parts of a text between separators, without empty ones.
std::vector<std::string> split(std::string_view text, char separator);

/// Removes blanks, tabs and line ends from both ends of a text.
std::string_view stripped(std::string_view text);

/// Puts a text into one line: its words with a blank between them.
std::string one_line(std::string_view text);

}  // namespace sys
