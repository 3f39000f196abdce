// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "literate/values/decimal.hpp"
#include "literate/values/format.hpp"

namespace literate {

/// A number after rounding, ready to be printed. The texts are those of the number / 10^exponent.
struct RoundedNumber {
  Decimal decimal;                   ///< the printed number, in the unit of the number
  std::string digits;                ///< «-1.23», with a point and without an exponent
  std::string standard = {};         ///< «22», in units of the last digit; empty for none
  std::string bound = {};            ///< «0.0018», after ±; empty for none
  std::optional<int> exponent = {};  ///< a power of ten common to all
};

/// Rounds a number, which for a percentage is the ratio. A number of unknown error (nullopt) gets
/// all digits of the format. A column of a table may print its numbers divided by 10^scale; the
/// decimals of fixed() then count after this division.
///
/// Throws std::invalid_argument if the format refuses the number: for a number or an error that is
/// not finite, an error below zero, digits out of range, a fraction in integer(), an error in
/// integer() or exact(), and no error in uncertain().
RoundedNumber rounded(const Format& format, double value, const std::optional<Number>& number,
                      int scale = 0);

/// Returns a number with the digits that a source prints, whose last digit is at 10^place. The
/// format decides on an exponent. Throws std::invalid_argument for a number with more digits.
RoundedNumber quoted(const Format& format, double value, int place, int scale = 0);

/// Returns how many significant digits the number has earned, 0 to 12: the most that `\val[n]`
/// prints. An exact number has earned all of its digits, and one of unknown error those of its
/// format.
int n_earned_digits(const Format& format, double value, const std::optional<Number>& number);

/// Prints a number as plain text: «1.2e3», «994(22)», «0.68007 ± 0.00096», «(1.2(3) ± 0.1)e-3 m».
/// The unit is plain text.
std::string plain_print(const RoundedNumber& number, std::string_view unit);

/// Prints a number as LaTeX for text and math mode. Five digits or more are in groups of three. The
/// unit is LaTeX for math mode.
std::string latex_print(const RoundedNumber& number, std::string_view unit);

/// Groups five digits or more by threes, with thin spaces, counted from the point to their left or
/// right.
std::string grouped(std::string_view digits, bool point_is_left);

}  // namespace literate
