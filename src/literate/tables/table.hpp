// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "literate/tables/cell.hpp"
#include "literate/tables/column.hpp"
#include "literate/text/place.hpp"

namespace literate {

/// A table, written as a booktabs tabular with the numbers of each column aligned at their points.
class Table {
 public:
  /// Throws Error if there is no column. `name` is that of `\tab{name}`.
  Table(std::string name, std::vector<Column> columns,
        const Place& place = std::source_location::current());

  /// Adds a row. Throws Error, naming table, row and column, unless the row has one cell for each
  /// column and each column can print its cell.
  Table& add_row(std::vector<Cell> cells, const Place& place = std::source_location::current());

  /// Adds a note below the table, LaTeX.
  Table& note(std::string text, const Place& place = std::source_location::current());

  const std::string& name() const { return name_; }
  const std::vector<Column>& columns() const { return columns_; }
  const std::vector<std::vector<Cell>>& rows() const { return rows_; }
  const std::vector<std::string>& notes() const { return notes_; }

  /// Which column has this heading. Throws Error, with the nearest heading, unless one has.
  std::size_t column(const std::string& heading,
                     const Place& place = std::source_location::current()) const;

  /// The tabular, with its notes below it. It needs LaTeX's own commands, booktabs and array.
  std::string latex() const;

  /// The rows as CSV: headings with units, numbers that read back the same, a percentage as its
  /// ratio. A column whose numbers have bounds or standard uncertainties is followed by one for
  /// these, «bound» or «standard». The notes follow as lines that begin with #.
  std::string csv() const;

  /// What each cell prints, as plain text with the power of ten of the head: 3.5e-2.
  std::vector<std::vector<std::string>> printed() const;

 private:
  std::string name_;
  std::vector<Column> columns_;
  std::vector<std::vector<Cell>> rows_;
  std::vector<std::string> notes_;
};

}  // namespace literate
