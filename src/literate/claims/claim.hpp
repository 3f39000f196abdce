// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "literate/claims/criterion.hpp"
#include "literate/values/value.hpp"

namespace literate {

/// What the computation finds about a statement.
enum class Verdict { confirmed, partly, refuted, undecided };

/// Names a verdict: «confirmed», «partly confirmed», «refuted» or «undecided».
std::string_view name_of(Verdict verdict);

/// Returns confirmed if the statement holds, else refuted.
Verdict confirmed_if(bool holds);

/// Returns confirmed if the statement holds in all of `n_cases` cases, refuted if it holds in none,
/// else partly.
Verdict confirmed_in(long n_holding, long n_cases);

/// Returns undecided if one of the criteria is; else confirmed if all hold, refuted if all fail,
/// and partly confirmed in between. There must be at least one.
Verdict verdict_of(const std::vector<Criterion>& criteria);

/// A statement that the computation checks, and its verdict. All texts are plain, not LaTeX.
///
/// With `criteria` these alone decide: what was computed, the tolerance and the verdict come from
/// them, and must not be given besides.
struct Claim {
  std::string sentence;              ///< what is claimed, one sentence with its full stop
  std::string place;                 ///< who states it and where: «paper, Results, p. 3»
  Value stated = Value::text("");    ///< the value as stated; an empty text if there is none
  Value computed = Value::text("");  ///< the value as computed here
  std::string route;                 ///< how the value was computed, independently of the statement
  std::string tolerance = "";        ///< what difference still counts as agreement, and why
  Verdict expected = Verdict::undecided;  ///< the verdict that the prose gives
  Verdict found = Verdict::undecided;     ///< the verdict of the computation
  std::vector<Criterion> criteria = {};   ///< what decides, each with its limit and its reason
};

/// Fills in what the criteria decide; a claim without criteria stays as it is. Throws
/// std::invalid_argument if a computed value or a tolerance is given beside criteria.
Claim decided(Claim claim);

}  // namespace literate
