// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "config/table.hpp"

namespace parameters {

/// A number as printed in the paper. It represents every number that rounds to it: 1.6236048e-006
/// represents all numbers within half a unit of its last digit.
class PrintedNumber {
 public:
  /// Parses a decimal number with or without an exponent. Throws std::invalid_argument for any
  /// other text.
  explicit PrintedNumber(std::string text);

  const std::string& text() const { return text_; }
  double value() const { return value_; }

  /// The power of ten of the last printed place: −13 for 1.6236048e-006.
  int place() const { return place_; }

  /// One unit of the last printed place: 1e-13 for 1.6236048e-006.
  double last_place() const;

  /// The number of significant digits printed.
  int n_digits() const { return n_digits_; }

  /// Whether `number`, rounded to as many significant digits, prints the same digits.
  bool agrees_with(double number) const;

 private:
  std::string text_;
  double value_ = 0;
  int place_ = 0;
  int n_digits_ = 0;
};

/// Read a number, or several, that the case file quotes to preserve their digits. Throw
/// config::Error with the position of the key for a text that is not a decimal number.
PrintedNumber printed_number(const config::Table& table, const std::string& key);
std::vector<PrintedNumber> printed_numbers(const config::Table& table, const std::string& key);

}  // namespace parameters
