// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "literate/claims/criterion.hpp"

namespace literate {

/// Undecided if one of the criteria is; else holds or fails if all do, and holds in part in
/// between. There must be at least one.
Verdict verdict_of(const std::vector<Criterion>& criteria);

/// How the computation checks a statement, whose sentence is in the prose.
struct Claim {
  std::string route = {};                 ///< how it was computed, independently of it (LaTeX)
  Verdict expected = Verdict::undecided;  ///< the verdict that the prose gives
  std::vector<Criterion> criteria = {};   ///< what decides

  Verdict verdict() const { return verdict_of(criteria); }
};

/// Something that must hold for the computation to be trusted.
struct Check {
  std::string statement;  ///< LaTeX
  bool passed = false;
  std::vector<Criterion> criteria = {};  ///< what decided; none for a fact that is no number
};

/// Every criterion with what was found and what was asked, for a message.
std::string text_of(const std::vector<Criterion>& criteria);

}  // namespace literate
