// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "literate/values/decimal.hpp"
#include "literate/values/format.hpp"
#include "literate/values/number.hpp"

namespace literate {

/// A number as a format rounds it, ready to be printed. The texts are divided by 10^exponent.
struct RoundedNumber {
  Decimal decimal;                   ///< what is printed, in the unit of the number
  std::string digits;                ///< «-1.23», with a point and without an exponent
  std::string standard = {};         ///< «22», in units of the last digit; empty for none
  std::string bound = {};            ///< «0.0018», behind ±; empty for none
  std::optional<int> exponent = {};  ///< a power of ten of all of it
};

/// Rounds a number; of a percentage it is the ratio. What nobody knows the uncertainty of (nullopt)
/// has as many digits as the format says. A column of a table may print all numbers divided by
/// 10^scale; then the decimals of fixed() are of these.
///
/// Throws std::invalid_argument for what the format refuses: a number or an uncertainty that is not
/// finite, an uncertainty below zero, digits out of range, a fraction for integer(), an error
/// beside an exact or whole number, none for uncertain().
RoundedNumber rounded(const Format& format, double value, const std::optional<Number>& number,
                      int scale = 0);

/// A number that a source prints with its last digit at 10^place, with these digits; the format
/// says whether it has an exponent. Throws std::invalid_argument for one that has more digits.
RoundedNumber quoted(const Format& format, double value, int place, int scale = 0);

/// How many significant digits the number has earned, 0 to 12, which is the most that `\val[n]`
/// prints: of an exact number all that it has, of one without a known error those of its format.
int n_earned_digits(const Format& format, double value, const std::optional<Number>& number);

/// «1.2e3», «994(22)», «0.68007 ± 0.00096», «(1.2(3) ± 0.1)e-3 m»; the unit is plain text.
std::string plain_print(const RoundedNumber& number, std::string_view unit);

/// The same as LaTeX, for text and math mode. Digits are in groups of three where there are five or
/// more. The unit is LaTeX for math mode.
std::string latex_print(const RoundedNumber& number, std::string_view unit, bool is_unit_attached);

/// Puts a thin space after every third of five digits or more, counted from the point, which is
/// left or right of them.
std::string grouped(std::string_view digits, bool point_is_left);

}  // namespace literate
