// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "literate/tables/column.hpp"
#include "literate/values/rounding.hpp"

namespace literate {

/// Throws std::invalid_argument if the column cannot print the cell: for a number that is not
/// finite, a bare number in a column that is not exact, a number in a column of texts, and whatever
/// the column's format refuses.
void require_printable(const Column& column, const Cell& cell);

/// Prints one column of a table, all of whose cells must be printable.
class PrintedColumn {
 public:
  PrintedColumn(const Column& column, const std::vector<const Cell*>& cells);

  /// The column's type in a tabular: l, p{4.5cm} or c.
  std::string specification() const;

  const std::string& heading() const { return column_.heading(); }
  const std::string& group() const { return column_.group(); }

  /// The unit in parentheses with the common power of ten, as LaTeX; empty without both.
  std::string unit() const;

  /// A cell as LaTeX. Numbers are padded with spaces to the same width, so that their decimal
  /// points align in a centred column.
  std::string cell(std::size_t row) const;

  /// A cell as plain text; a number includes the power of ten of the head.
  std::string plain(std::size_t row) const;

 private:
  /// The space that a number needs left and right of its point, and for its error and exponent.
  struct Width {
    bool negative = false;
    std::size_t n_whole = 1;
    std::size_t n_decimals = 0;
    std::string error;     ///< the longest of «(22)» and «\pm 0.012»
    std::string exponent;  ///< the longest of «-6»
  };
  struct Printed {
    std::string text;  ///< of a cell without a number
    std::optional<RoundedNumber> number;
  };

  static Width width_of(const RoundedNumber& number);
  std::string aligned(const RoundedNumber& number) const;

  Column column_;
  int exponent_;  // of the head
  std::vector<Printed> cells_;
  Width widest_;
};

}  // namespace literate
