// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace literate {

enum class ColumnKind { fixed, common_exponent, scientific, integer, text };

/// How a column is printed; the factories of Column say what each kind means.
struct ColumnFormat {
  ColumnKind kind;
  std::string heading;  ///< LaTeX
  std::string unit;     ///< literal text; empty for none
  int exponent = 0;     ///< the power of ten that the unit line holds
  int digits = 0;       ///< decimals of fixed numbers, significant digits of others
};

/// One column of a Table: its heading (LaTeX), its unit (literal text) and how it prints numbers.
/// Every factory throws std::invalid_argument for a unit that require_unit refuses.
class Column {
 public:
  /// Numbers with `decimals` digits after the point.
  static Column fixed(std::string heading, std::string unit, int decimals);

  /// Numbers divided by 10^exponent, which moves to the unit line: (10⁻⁶ in).
  static Column scaled(std::string heading, std::string unit, int exponent, int decimals);

  /// As scaled(), with the exponent of the column's largest magnitude and `n_digits` digits there.
  static Column common_exponent(std::string heading, std::string unit, int n_digits);

  /// Numbers with `n_digits` significant digits and each its own exponent.
  static Column scientific(std::string heading, std::string unit, int n_digits);

  /// Whole numbers; a cell with a fraction throws std::invalid_argument when the table is written.
  static Column integer(std::string heading, std::string unit = "");

  /// Plain text, set flush left.
  static Column text(std::string heading);

  const ColumnFormat& format() const { return format_; }

 private:
  explicit Column(ColumnFormat format);

  ColumnFormat format_;
};

}  // namespace literate
