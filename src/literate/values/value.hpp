// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "literate/values/decimal.hpp"
#include "numerics/estimate.hpp"

namespace literate {

/// A value as the document prints it, with the unrounded number.
///
/// Units are literal text such as "in", "psi", "lbf/in" or "in^2". Numbers are rounded half to even
/// from the exact binary value; a number that rounds to zero has no sign. Every factory throws
/// std::invalid_argument for a NaN, an infinity, a number of digits out of range, or a unit with
/// one of % # & _ $ ~ \ { }.
class Value {
 public:
  static Value integer(std::int64_t number, std::string_view unit = "");

  /// Prints `n_digits` significant digits, with an exponent outside [1e-3, 1e6).
  static Value significant(double number, int n_digits, std::string_view unit = "");

  /// Prints `decimals` digits after the point, 0 ≤ decimals ≤ 100.
  static Value fixed(double number, int decimals, std::string_view unit = "");

  /// Prints `n_digits` significant digits and always an exponent, except for zero.
  static Value scientific(double number, int n_digits, std::string_view unit = "");

  /// Prints the digits that `abs_error` supports, at most `max_digits`. The last digit stands at
  /// 10^p, the least power of ten ≥ 2·abs_error, so it is wrong by one at most. With no error it
  /// prints as exact() does. Also throws std::invalid_argument for an error that is negative or not
  /// finite.
  static Value estimate(numerics::Estimate estimate, std::string_view unit = "",
                        int max_digits = 12);

  /// Prints the number and, in parentheses, the error bound in units of its last digit, rounded up
  /// to two digits: 0.78615138(12) for 0.786151378 and 1.2e-7. With no error it prints as exact()
  /// does. Also throws std::invalid_argument for an error that is negative or not finite.
  static Value with_uncertainty(numerics::Estimate estimate, std::string_view unit = "");

  /// Prints 100·ratio with `decimals` digits after the point and a per-cent sign; number() is the
  /// ratio itself.
  static Value percent(double ratio, int decimals);

  /// As percent() with the digits that exact() prints, and with at most `max_digits` significant
  /// digits of the ratio, fewer where its error reaches beyond the last of them.
  static Value exact_percent(double ratio);
  static Value percent_significant(numerics::Estimate ratio, int max_digits);

  /// Print as the factories for a plain number do, but fewer digits if the error is greater than
  /// one unit of the last of them. Also throw std::invalid_argument for an error that is negative
  /// or not finite.
  static Value significant(numerics::Estimate estimate, int max_digits, std::string_view unit = "");
  static Value fixed(numerics::Estimate estimate, int max_decimals, std::string_view unit = "");
  static Value scientific(numerics::Estimate estimate, int max_digits, std::string_view unit = "");
  static Value percent(numerics::Estimate ratio, int max_decimals);

  /// Print as scientific() and percent() do, but round up: for bounds that a sentence states. The
  /// number must not be negative.
  static Value scientific_bound(double number, int n_digits, std::string_view unit = "");
  static Value percent_bound(double ratio, int decimals);

  /// Do the same for a number with an error: print no less than their sum, and no digit below the
  /// error.
  static Value scientific_bound(numerics::Estimate estimate, int n_digits,
                                std::string_view unit = "");
  static Value percent_bound(numerics::Estimate ratio, int decimals);

  /// Prints the fewest digits that read back as the same double: for parameters.
  static Value exact(double number, std::string_view unit = "");

  /// Prints plain text, escaped for LaTeX.
  static Value text(std::string_view text);

  /// Returns the same value with a bound on its error, in the unit of number(), which for a
  /// percentage is the ratio. Throws std::invalid_argument, naming number, printed text and bound,
  /// if the last printed place is less than the bound. Also throws it for text, for a value that
  /// has a bound already, and for a bound that is negative or not finite.
  Value within(double abs_error) const;

  /// The value as LaTeX, such as `\qty{1.5e-6}{in}`, for text and math mode.
  const std::string& latex() const { return latex_; }

  /// The value as plain text, such as "1.5e-6 in".
  const std::string& printed() const { return printed_; }

  /// The unrounded number; none for text.
  const std::optional<double>& number() const { return number_; }

  /// The error bound that came with an estimate or from within(), if any.
  const std::optional<double>& abs_error() const { return abs_error_; }

  const std::string& unit() const { return unit_; }

  /// Whether the number is a ratio that is printed in per cent.
  bool is_percentage() const { return is_percentage_; }

 private:
  Value() = default;
  static Value quantity(double number, const std::string& digits, std::string_view unit);
  static Value percentage(double ratio, Decimal rounded);
  static Value plain_or_padded(numerics::Estimate estimate, const Decimal& rounded,
                               std::string_view unit);
  Value at_place(int place) const;
  Value with_error(double abs_error) const;

  std::string latex_;
  std::string printed_;
  std::optional<double> number_;
  std::optional<double> abs_error_;
  int place_ = 0;  // the power of ten of the last printed digit, in the unit of number_
  std::string unit_;
  bool is_percentage_ = false;
};

}  // namespace literate
