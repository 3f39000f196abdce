// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/text.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <numeric>

namespace sys {
namespace {

constexpr std::string_view blanks = " \t\r\n";

/// Counts the single-letter edits that turn `a` into `b` (Levenshtein distance).
std::size_t distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({row[j] + 1, row[j + 1] + 1, replaced});
    }
  }
  return row.back();
}

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

std::string csv_field(std::string_view text) {
  const bool is_plain = text.find_first_of(",\"\r\n") == text.npos && !text.starts_with('#') &&
                        stripped(text).size() == text.size();
  if (is_plain) return std::string(text);
  std::string field = "\"";
  for (const char c : text) field += c == '"' ? "\"\"" : std::string(1, c);
  return field + "\"";
}

std::string csv_line(const std::vector<std::string>& fields) {
  std::string line;
  for (const std::string& field : fields)
    line += (&field == &fields.front() ? "" : ",") + csv_field(field);
  return line + "\n";
}

std::optional<std::string> nearest_name(const std::string& unknown,
                                        const std::set<std::string>& names) {
  const auto nearest = std::ranges::min_element(
      names, {}, [&](const std::string& name) { return distance(unknown, name); });
  if (nearest == names.end()) return std::nullopt;
  const std::size_t limit = std::max<std::size_t>(2, unknown.size() / 3);
  const std::size_t n_edits = distance(unknown, *nearest);
  if (n_edits > limit || n_edits >= unknown.size()) return std::nullopt;
  return *nearest;
}

std::string suggestion(const std::string& unknown, const std::set<std::string>& names) {
  const auto nearest = nearest_name(unknown, names);
  return nearest ? fmt::format(", did you mean '{}'?", *nearest) : "";
}

}  // namespace sys
