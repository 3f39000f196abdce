// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "literate/values/value.hpp"

namespace literate {

/// How a statement fares when it is tried.
enum class Verdict { confirmed, partly, refuted };

/// confirmed, partly confirmed or refuted.
std::string_view name_of(Verdict verdict);

/// Confirmed if it holds, else refuted.
Verdict confirmed_if(bool holds);

/// Confirmed if it holds in all of `n_cases` cases, refuted if in none, else partly.
Verdict confirmed_in(long n_holding, long n_cases);

/// A statement that the computation tries, and what came of it. Texts are plain, not LaTeX.
struct Claim {
  std::string sentence;              ///< what is claimed, one sentence with its full stop
  std::string place;                 ///< who says so and where, as «paper, Results, p. 3»
  Value stated = Value::text("");    ///< the value as stated; an empty text if none is
  Value computed = Value::text("");  ///< the value as computed here
  std::string route;                 ///< by what it was computed, with no part of the statement
  std::string tolerance;             ///< what still counts as agreement, and why that much
  Verdict expected;                  ///< what the prose says of it
  Verdict found;                     ///< what the computation says of it
};

}  // namespace literate
