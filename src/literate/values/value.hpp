// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "literate/values/decimal.hpp"
#include "numerics/estimate.hpp"

namespace literate {

/// A value as the document will print it, with the number behind it.
///
/// Units are literal text such as "in", "psi", "lbf/in" or "in^2". Numbers are rounded half to
/// even from the exact binary value; a number that rounds to zero has no sign. Every factory
/// throws std::invalid_argument for a NaN, an infinity, digits out of range, or a unit that holds
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

  /// Prints the digits that `abs_error` supports: with 10^p the least power of ten
  /// ≥ 2·abs_error, the last digit stands at 10^p, so it is wrong by one at most. Zero error
  /// prints as exact() does. At most `max_digits` digits are printed. Throws
  /// std::invalid_argument as well when the error is negative or not finite.
  static Value estimate(numerics::Estimate estimate, std::string_view unit = "",
                        int max_digits = 12);

  /// Prints the digits and, in parentheses, the error bound in units of the last of them, two
  /// digits rounded up: 0.78615138(12) for 0.786151378 and 1.2e-7. Zero error prints as exact()
  /// does. Throws std::invalid_argument as well when the error is negative or not finite.
  static Value with_uncertainty(numerics::Estimate estimate, std::string_view unit = "");

  /// Prints 100·ratio with `decimals` digits after the point and a per-cent sign; number() is
  /// the ratio.
  static Value percent(double ratio, int decimals);

  /// As those for a plain number, with at most that many digits or decimals: fewer where the error
  /// reaches beyond the last of them. Throw std::invalid_argument as well when the error is
  /// negative or not finite.
  static Value significant(numerics::Estimate estimate, int max_digits, std::string_view unit = "");
  static Value fixed(numerics::Estimate estimate, int max_decimals, std::string_view unit = "");
  static Value scientific(numerics::Estimate estimate, int max_digits, std::string_view unit = "");
  static Value percent(numerics::Estimate ratio, int max_decimals);

  /// As scientific() and percent(), rounded up: for what a sentence says is not exceeded. The
  /// number must not be negative.
  static Value scientific_bound(double number, int n_digits, std::string_view unit = "");
  static Value percent_bound(double ratio, int decimals);

  /// The same for what may be wrong itself: never less than number and error together, and no digit
  /// below the error.
  static Value scientific_bound(numerics::Estimate estimate, int n_digits,
                                std::string_view unit = "");
  static Value percent_bound(numerics::Estimate ratio, int decimals);

  /// Prints the fewest digits that read back as the same double: for parameters.
  static Value exact(double number, std::string_view unit = "");

  /// Prints plain text, escaped for LaTeX.
  static Value text(std::string_view text);

  /// The same print with a bound on how wrong its number is, in the number's unit (of a percentage,
  /// of the ratio). Digits have to be earned: throws std::invalid_argument, naming number, print
  /// and bound, when the last printed place is less than the bound. Also for text, for a value that
  /// has a bound already, and for one that is negative or not finite.
  Value within(double abs_error) const;

  /// What LaTeX reads, such as `\qty{1.5e-6}{in}`; works in text and in math mode.
  const std::string& latex() const { return latex_; }

  /// The same as plain text, such as "1.5e-6 in".
  const std::string& printed() const { return printed_; }

  /// The unrounded number; none for text.
  const std::optional<double>& number() const { return number_; }

  /// The bound given with an estimate or to within(); none if none was given.
  const std::optional<double>& abs_error() const { return abs_error_; }

  const std::string& unit() const { return unit_; }

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
  int place_ = 0;  // power of ten of the last printed digit, of the number
  std::string unit_;
};

}  // namespace literate
