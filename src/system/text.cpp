// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/text.hpp"

namespace sys {
namespace {

constexpr std::string_view blanks = " \t\r\n";

}  // namespace

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
