// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "literate/tables/column.hpp"
#include "literate/text/place.hpp"

namespace literate {

/// A table, printed as a booktabs tabular that aligns the numbers of a column at their points.
class Table {
 public:
  /// Throws Error if there is no column. `name` is that of `\tab{name}`.
  Table(std::string name, std::vector<Column> columns,
        const Place& place = std::source_location::current());

  /// Adds a row with one cell for each column. Throws Error, with table, row and column, for a
  /// different number of cells and for a cell that its column cannot print.
  Table& add_row(std::vector<Cell> cells, const Place& place = std::source_location::current());

  /// Adds a note (LaTeX) below the table.
  Table& note(std::string text, const Place& place = std::source_location::current());

  const std::string& name() const { return name_; }
  const std::vector<Column>& columns() const { return columns_; }
  const std::vector<std::vector<Cell>>& rows() const { return rows_; }
  const std::vector<std::string>& notes() const { return notes_; }

  /// Returns the tabular and its notes as LaTeX, which needs the packages booktabs and array.
  std::string latex() const;

  /// Returns the rows as CSV: headings with units, numbers that read back as the same doubles, and
  /// percentages as ratios. After a column whose numbers have bounds or standard uncertainties
  /// follow the columns «bound» and «standard». The notes are lines that begin with #.
  std::string csv() const;

  /// Returns each printed cell as plain text, with the power of ten of the head: 3.5e-2.
  std::vector<std::vector<std::string>> printed() const;

 private:
  std::string name_;
  std::vector<Column> columns_;
  std::vector<std::vector<Cell>> rows_;
  std::vector<std::string> notes_;
};

}  // namespace literate
