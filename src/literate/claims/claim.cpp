// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/claims/claim.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace literate {

std::string_view name_of(Verdict verdict) {
  constexpr std::array names{"confirmed", "partly confirmed", "refuted", "undecided"};
  return names.at(static_cast<std::size_t>(verdict));
}

Verdict verdict_of(const std::vector<Criterion>& criteria) {
  const auto all = [&](Outcome outcome) {
    return std::ranges::all_of(criteria,
                               [&](const Criterion& c) { return c.outcome() == outcome; });
  };
  const bool is_open = std::ranges::any_of(
      criteria, [](const Criterion& c) { return c.outcome() == Outcome::undecided; });
  if (criteria.empty() || is_open) return Verdict::undecided;
  if (all(Outcome::holds)) return Verdict::confirmed;
  return all(Outcome::fails) ? Verdict::refuted : Verdict::partly;
}

std::string text_of(const std::vector<Criterion>& criteria) {
  std::string text;
  for (const Criterion& criterion : criteria) {
    text += fmt::format("{}{} (asked: {})", text.empty() ? "" : "; ", criterion.computed(),
                        criterion.condition().plain);
    if (!criterion.missing().empty()) text += ", undecided: " + criterion.missing();
  }
  return text;
}

}  // namespace literate
