// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "literate/claims/criterion.hpp"

namespace literate {

/// What the computation finds about a statement.
enum class Verdict { confirmed, partly, refuted, undecided };

/// Names a verdict: «confirmed», «partly confirmed», «refuted» or «undecided».
std::string_view name_of(Verdict verdict);

/// Returns undecided if one of the criteria is; else confirmed if all hold, refuted if all fail,
/// and partly confirmed in between. There must be at least one.
Verdict verdict_of(const std::vector<Criterion>& criteria);

/// How the computation checks a statement, whose sentence stands in the prose. The criteria alone
/// say what was computed, what was asked of it, and which verdict it has. All texts are plain, not
/// LaTeX.
struct Claim {
  std::string route;                      ///< how it was computed, independently of the statement
  Verdict expected = Verdict::undecided;  ///< the verdict that the prose gives
  std::vector<Criterion> criteria;        ///< what decides, each with its limit and its reason

  Verdict found() const { return verdict_of(criteria); }
};

/// Every criterion with what was computed and what was asked, for a message.
std::string text_of(const std::vector<Criterion>& criteria);

}  // namespace literate
