// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace literate {

enum class ColumnKind { fixed, common_exponent, scientific, integer, text };

/// The heading of a column and how it prints numbers. The factories of Column explain the kinds.
struct ColumnFormat {
  ColumnKind kind;
  std::string heading;  ///< LaTeX
  std::string unit;     ///< literal text; empty for none
  int exponent = 0;     ///< the power of ten that the unit line states
  int digits = 0;       ///< decimals of fixed numbers, significant digits of others
};

/// One column of a Table: its heading (LaTeX), its unit (literal text) and how it prints numbers.
/// Every factory throws std::invalid_argument for a unit that require_unit refuses.
class Column {
 public:
  /// Prints numbers with `decimals` digits after the point.
  static Column fixed(std::string heading, std::string unit, int decimals);

  /// Prints numbers divided by 10^exponent, which the unit line states: (10⁻⁶ in).
  static Column scaled(std::string heading, std::string unit, int exponent, int decimals);

  /// Prints as scaled() does, with the exponent of the column's largest magnitude, which gets
  /// `n_digits` digits.
  static Column common_exponent(std::string heading, std::string unit, int n_digits);

  /// Prints each number with `n_digits` significant digits and an exponent of its own.
  static Column scientific(std::string heading, std::string unit, int n_digits);

  /// Prints whole numbers; a cell with a fraction throws std::invalid_argument when the table is
  /// written.
  static Column integer(std::string heading, std::string unit = "");

  /// Prints plain text, flush left.
  static Column text(std::string heading);

  const ColumnFormat& format() const { return format_; }

 private:
  explicit Column(ColumnFormat format);

  ColumnFormat format_;
};

}  // namespace literate
