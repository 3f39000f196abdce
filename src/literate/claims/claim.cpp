// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/claims/claim.hpp"

#include <algorithm>

namespace literate {

Verdict verdict_of(const std::vector<Criterion>& criteria) {
  const auto have_all = [&](Verdict verdict) {
    return std::ranges::all_of(criteria,
                               [=](const Criterion& c) { return c.verdict() == verdict; });
  };
  if (std::ranges::any_of(criteria,
                          [](const Criterion& c) { return c.verdict() == Verdict::undecided; })) {
    return Verdict::undecided;
  }
  if (have_all(Verdict::holds)) return Verdict::holds;
  return have_all(Verdict::fails) ? Verdict::fails : Verdict::holds_in_part;
}

std::string text_of(const std::vector<Criterion>& criteria) {
  std::string text;
  for (const Criterion& criterion : criteria) {
    text += (text.empty() ? "" : "; ") + criterion.text();
  }
  return text;
}

}  // namespace literate
