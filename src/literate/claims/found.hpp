// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "literate/values/value.hpp"

namespace literate {

/// A phrase as plain text (for messages) and as LaTeX.
struct Phrase {
  std::string plain;
  std::string latex;
};

/// Inserts phrases into words that are the same in plain text and LaTeX.
Phrase phrase(std::string_view words, const Phrase& first, const Phrase& second = {},
              const Phrase& third = {});

Phrase phrase_of(const Value& value);

/// The side of the limit on which a number must lie.
enum class Side { at_most, at_least };

/// Prints the result of a criterion so that a reader can compare it with the limit.
///
/// The quantity is printed in its format. If rounding moved it across the limit, it gets more
/// digits or its error. A quantity smaller in magnitude than its `error` is printed as a bound: «at
/// most 3.7e-11».
Phrase found_phrase(const Value& quantity, double error, double limit, Side side);

/// Prints a quantity with its error, which reaches across the limit.
Phrase undecided_phrase(const Value& quantity, double error, double limit);

}  // namespace literate
