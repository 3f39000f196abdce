// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "literate/tables/cell.hpp"
#include "literate/tables/column.hpp"

namespace literate {

/// A table, written as a booktabs tabular whose numbers stand on the decimal point.
class Table {
 public:
  /// Throws std::invalid_argument when there is no column.
  explicit Table(std::vector<Column> columns);

  /// Throws std::invalid_argument unless there is one cell a column.
  Table& add_row(std::vector<Cell> cells);

  /// The tabular, with siunitx S columns whose table-format is taken from the data. Throws
  /// std::invalid_argument for a number that is not finite, or in a text column.
  std::string latex() const;

  /// The same as CSV, with the headings and units as in LaTeX and numbers that read back the same.
  std::string csv() const;

 private:
  std::vector<Column> columns_;
  std::vector<std::vector<Cell>> rows_;
};

}  // namespace literate
