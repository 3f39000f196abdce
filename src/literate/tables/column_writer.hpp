// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "literate/tables/cell.hpp"
#include "literate/tables/column.hpp"
#include "literate/tables/number_cell.hpp"

namespace literate {

/// Writes one column of a table as LaTeX: header lines, and cells of equal width, so that the
/// decimal points stand below one another. (An S column of siunitx does the same, but takes 1 ms
/// for each cell in each run of LaTeX.)
class ColumnWriter {
 public:
  /// Writes all cells; throws std::invalid_argument as Table::latex does.
  ColumnWriter(ColumnFormat format, const std::vector<const Cell*>& cells);

  /// The column type: `l` for text, `c` for numbers.
  std::string specification() const;

  std::string heading() const;

  /// The unit in parentheses, with the power of ten factored out; empty if there is none.
  std::string unit() const;

  /// One cell. A number is \LiterateCell{format}{number}{mathematics}: the widest number of the
  /// column as siunitx's table-format, the number itself, and the number padded to that width.
  std::string cell(std::size_t row) const;

 private:
  struct Written {
    std::string text;
    bool is_number = false;
  };
  Written written(const Cell& cell);
  std::string number_text(const Cell& cell) const;

  ColumnFormat format_;  // a common exponent is turned into the fixed one that the cells have
  NumberWidth width_;
  std::vector<Written> cells_;
};

}  // namespace literate
