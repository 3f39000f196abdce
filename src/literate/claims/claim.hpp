// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "literate/claims/criterion.hpp"

namespace literate {

/// Returns undecided if any criterion is undecided, holds or fails if all of them do, and holds in
/// part otherwise. There must be at least one criterion.
Verdict verdict_of(const std::vector<Criterion>& criteria);

/// How the computation tests a statement of the prose.
struct Claim {
  std::string route = {};                 ///< how the tested numbers were computed (LaTeX)
  Verdict expected = Verdict::undecided;  ///< the verdict that the prose relies on
  std::vector<Criterion> criteria = {};   ///< the tests that decide it

  Verdict verdict() const { return verdict_of(criteria); }
};

/// A condition that must hold before the computation can be trusted.
struct Check {
  std::string statement;  ///< LaTeX
  bool passed = false;
  std::vector<Criterion> criteria = {};  ///< empty for a fact that needs no number
};

/// Describes each criterion with its result and its limit, for messages.
std::string text_of(const std::vector<Criterion>& criteria);

}  // namespace literate
