// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "literate/values/value.hpp"

namespace literate {

/// What the computation finds about a statement.
enum class Verdict { confirmed, partly, refuted };

/// Names a verdict: «confirmed», «partly confirmed» or «refuted».
std::string_view name_of(Verdict verdict);

/// Returns confirmed if the statement holds, else refuted.
Verdict confirmed_if(bool holds);

/// Returns confirmed if the statement holds in all of `n_cases` cases, refuted if it holds in none,
/// else partly.
Verdict confirmed_in(long n_holding, long n_cases);

/// A statement that the computation checks, and its verdict. All texts are plain, not LaTeX.
struct Claim {
  std::string sentence;              ///< what is claimed, one sentence with its full stop
  std::string place;                 ///< who states it and where: «paper, Results, p. 3»
  Value stated = Value::text("");    ///< the value as stated; an empty text if there is none
  Value computed = Value::text("");  ///< the value as computed here
  std::string route;                 ///< how the value was computed, independently of the statement
  std::string tolerance;             ///< what difference still counts as agreement, and why
  Verdict expected;                  ///< the verdict that the prose gives
  Verdict found;                     ///< the verdict of the computation
};

}  // namespace literate
