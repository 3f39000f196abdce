// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "literate/table.hpp"

namespace literate {

/// Turns one column of a table into LaTeX: header lines, cells, and an S column to fit them.
class ColumnWriter {
 public:
  /// Writes all cells; throws std::invalid_argument as Table::latex does.
  ColumnWriter(const Column& column, const std::vector<const Cell*>& cells);

  /// The column type: `l`, or `S[table-format=…]`.
  std::string specification() const;

  /// The heading, in braces so that siunitx leaves it alone.
  std::string heading() const;

  /// The unit in parentheses, with the power of ten factored out; empty if there is none.
  std::string unit() const;

  const std::string& cell(std::size_t row) const { return cells_[row]; }

 private:
  /// Integer digits, decimals and exponent digits that the column must hold.
  struct Width {
    bool negative = false;
    std::size_t n_integer = 1;
    std::size_t n_decimals = 0;
    bool negative_exponent = false;
    std::size_t n_exponent = 0;
  };

  std::string written(const Cell& cell);
  std::string number_text(const Cell& cell) const;
  void widen_for(std::string_view number);

  const Column& column_;
  int exponent_;
  int decimals_;
  Width width_;
  std::vector<std::string> cells_;
};

}  // namespace literate
