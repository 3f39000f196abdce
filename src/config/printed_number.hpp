// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace config {

/// A number as it stands in print: 1.6236048e-006 is not a point but every number that rounds to
/// it.
class PrintedNumber {
 public:
  /// Takes a decimal number, with exponent or without; throws std::invalid_argument for other text.
  explicit PrintedNumber(std::string text);

  const std::string& text() const { return text_; }
  double value() const { return value_; }

  /// The power of ten of the last printed place: −13 for 1.6236048e-006.
  int place() const { return place_; }

  /// One unit of the last printed place: 1e-13 for 1.6236048e-006.
  double last_place() const;

  /// How many significant digits are printed.
  int n_digits() const { return n_digits_; }

  /// Whether `number`, rounded to the last printed place, prints the same digits.
  bool agrees_with(double number) const;

  /// How many leading digits agree when `number` is rounded to 1, 2, … digits as the print is; up
  /// to n_digits().
  int n_agreeing_digits(double number) const;

 private:
  std::string text_;
  double value_ = 0;
  int place_ = 0;
  int n_digits_ = 0;
};

}  // namespace config
