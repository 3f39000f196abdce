// SPDX-License-Identifier: GPL-3.0-or-later
// Characters, words and lines of a text, fields of CSV files, and similar names; independent of the
// locale.
#pragma once

#include <optional>
#include <set>
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

/// Formats a field of a CSV file (RFC 4180), in quotes if it contains special characters.
std::string csv_field(std::string_view text);

/// Formats a line of a CSV file, including the line end.
std::string csv_line(const std::vector<std::string>& fields);

/// Finds the name that is most similar to an unknown one, by the number of single-letter edits.
/// Returns none if this number exceeds both two and a third of the letters, or if all differ.
std::optional<std::string> nearest_name(const std::string& unknown,
                                        const std::set<std::string>& names);

/// Returns «, did you mean 'x'?» with that name; empty if there is none.
std::string suggestion(const std::string& unknown, const std::set<std::string>& names);

}  // namespace sys
