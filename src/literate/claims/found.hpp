// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/core.h>
#include <string>
#include <string_view>

#include "literate/values/value.hpp"

namespace literate {

/// A phrase as plain text, for messages, and as LaTeX.
struct Phrase {
  std::string plain;
  std::string latex;

  const std::string& printed() const { return plain; }
};

/// Puts values and phrases into words that are the same in LaTeX: phrase("{} of {}", part, whole).
template <typename... Parts>
Phrase phrase(std::string_view words, const Parts&... parts) {
  const auto latex_of = [](const auto& part) -> const std::string& {
    if constexpr (requires { part.latex(); }) {
      return part.latex();
    } else {
      return part.latex;
    }
  };
  return {fmt::format(fmt::runtime(words), parts.printed()...),
          fmt::format(fmt::runtime(words), latex_of(parts)...)};
}

/// Which side of its limit a number has to be on.
enum class Side { at_most, at_least };

/// What a criterion found, as a reader can hold it against the limit.
///
/// Prints the quantity to the nearest number, with the digits of its format that its error
/// supports. A format that rounds up, which is for sentences that state a bound, prints two digits
/// at least. A quantity that is less than its error in magnitude is told by what it is at most, or
/// at least: number and error together, rounded away from the number to two digits. Where the
/// rounded number would lie on the other side of the limit than the number itself, more digits are
/// printed, and the error where it does not support them.
///
/// What counts as its error are the bound and `k` standard uncertainties. Throws
/// std::invalid_argument for a quantity without a number or without an error.
Phrase found_phrase(const Value& quantity, double limit, Side side, double k = 1);

/// The same of a quantity whose error leaves open on which side it is: with the error, so that a
/// reader sees that it reaches across the limit.
Phrase undecided_phrase(const Value& quantity, double limit, Side side, double k = 1);

/// What the difference of two numbers is held against: a number of their unit, or a ratio.
enum class Distance { absolute, relative };

/// «0.2999, 1.0e-4 from 0.3»: two numbers and how far they are apart.
///
/// What is printed is consistent: the difference of the two printed numbers is the printed
/// difference, as far as that is rounded, and lies on the same side of the limit as what was
/// tested. Only two numbers that agree and are printed alike may differ by less than their digits
/// show. Where
/// the digits of the formats contradict this, more of them are printed, and the errors where these
/// support no more. The difference comes with its error.
Phrase apart_phrase(const Value& computed, const Value& stated, const Value& difference,
                    double limit, Side side, Distance distance, double k = 1);

}  // namespace literate
