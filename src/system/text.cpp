// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/text.hpp"

#include <algorithm>

#include <utf8.h>

namespace sys {
namespace {

constexpr std::string_view blanks = " \t\r\n";

}  // namespace

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

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const auto end = text.find('\n');
    std::string_view line = text.substr(0, end);
    if (line.ends_with('\r')) line.remove_suffix(1);
    lines.push_back(line);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  return lines;
}

std::vector<std::string> split(std::string_view text, char separator) {
  std::vector<std::string> parts;
  while (!text.empty()) {
    const std::string_view part = text.substr(0, text.find(separator));
    if (!part.empty()) parts.emplace_back(part);
    text.remove_prefix(std::min(text.size(), part.size() + 1));
  }
  return parts;
}

std::string_view stripped(std::string_view text) {
  const auto first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::string one_line(std::string_view text) {
  std::string line;
  for (text = stripped(text); !text.empty(); text = stripped(text)) {
    const std::string_view word = text.substr(0, text.find_first_of(blanks));
    line.append(line.empty() ? "" : " ").append(word);
    text.remove_prefix(word.size());
  }
  return line;
}

}  // namespace sys
