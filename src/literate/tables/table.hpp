// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "literate/tables/cell.hpp"
#include "literate/tables/column.hpp"

namespace literate {

/// A table that is written as a booktabs tabular with its numbers aligned at the decimal point.
class Table {
 public:
  /// Throws std::invalid_argument if there is no column.
  explicit Table(std::vector<Column> columns);

  /// Adds a row; throws std::invalid_argument unless it has one cell for each column.
  Table& add_row(std::vector<Cell> cells);

  /// The headings of the columns, as LaTeX.
  std::vector<std::string> headings() const;

  /// Writes the tabular. Throws std::invalid_argument for a number that is not finite, and for one
  /// in a text column.
  std::string latex() const;

  /// Writes the table as CSV, with headings and units as in LaTeX and numbers that read back the
  /// same.
  std::string csv() const;

 private:
  std::vector<Column> columns_;
  std::vector<std::vector<Cell>> rows_;
};

}  // namespace literate
