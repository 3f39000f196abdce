// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/nearest_name.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <numeric>
#include <vector>

namespace sys {
namespace {

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
