// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/claims/claim.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <stdexcept>

namespace literate {

std::string_view name_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::confirmed:
      return "confirmed";
    case Verdict::partly:
      return "partly confirmed";
    case Verdict::refuted:
      return "refuted";
    case Verdict::undecided:
      break;
  }
  return "undecided";
}

Verdict confirmed_if(bool holds) {
  return holds ? Verdict::confirmed : Verdict::refuted;
}

Verdict confirmed_in(long n_holding, long n_cases) {
  if (n_holding == 0) return Verdict::refuted;
  return n_holding == n_cases ? Verdict::confirmed : Verdict::partly;
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

Claim decided(Claim claim) {
  if (claim.criteria.empty()) return claim;
  if (!claim.computed.printed().empty() || !claim.tolerance.empty()) {
    throw std::invalid_argument(
        "a claim with criteria computes and tolerates what they say, and nothing besides");
  }
  std::string computed;
  for (const Criterion& criterion : claim.criteria) {
    computed += fmt::format("{}{}", computed.empty() ? "" : "; ", criterion.computed());
    claim.tolerance += fmt::format("{}{} ({})", claim.tolerance.empty() ? "" : "; ",
                                   criterion.condition(), criterion.reason());
    if (!criterion.missing().empty()) computed += fmt::format(" [{}]", criterion.missing());
  }
  claim.computed = Value::text(computed);
  claim.found = verdict_of(claim.criteria);
  return claim;
}

}  // namespace literate
