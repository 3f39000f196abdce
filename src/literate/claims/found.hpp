// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "literate/values/value.hpp"

namespace literate {

/// A phrase as plain text, for messages, and as LaTeX.
struct Phrase {
  std::string plain;
  std::string latex;
};

/// Puts values and phrases into words that are the same in both.
Phrase phrase(std::string_view words, const Phrase& first, const Phrase& second = {},
              const Phrase& third = {});

Phrase phrase_of(const Value& value);

/// Which side of its limit a number has to be on.
enum class Side { at_most, at_least };

/// What a criterion found, as a reader can compare it with the limit.
///
/// Prints the quantity as its format does, with more digits, or with its error, where the printed
/// number would be on the other side of the limit than the quantity itself. A quantity that is less
/// than its `error` in magnitude is printed by what it is at most, or at least: «at most 3.7e-11».
Phrase found_phrase(const Value& quantity, double error, double limit, Side side);

/// The same of a quantity whose error leaves open on which side it is: with the error.
Phrase undecided_phrase(const Value& quantity, double error, double limit);

}  // namespace literate
