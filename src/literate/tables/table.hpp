// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <source_location>
#include <string>
#include <utility>
#include <vector>

#include "literate/tables/cell.hpp"
#include "literate/tables/column.hpp"

namespace literate {

/// A note below a table; a mark ties it to cells.
struct TableNote {
  std::string mark;  ///< plain text; empty for a note on the whole table
  std::string text;  ///< LaTeX
};

/// The heading of a column in CSV: «group: heading (unit)», as plain text.
std::string csv_heading(const ColumnFormat& format);

/// A table that is written as a booktabs tabular with its numbers aligned at the decimal point.
class Table {
 public:
  using Location = std::source_location;

  /// Throws std::invalid_argument if there is no column. The name is that by which the document
  /// uses it; Document::table() says what it may consist of.
  Table(std::string name, std::vector<Column> columns, Location location = Location::current());

  /// Adds a row. Throws std::invalid_argument unless it has one cell for each column, each of which
  /// its column can print and none of which has a digit that is not earned: see require_printable.
  /// The message names table, row and column, and the lines of the code: of the row, and where the
  /// table was begun.
  Table& add_row(std::vector<Cell> cells, Location location = Location::current());

  /// Adds a note below the table, LaTeX.
  Table& note(std::string text);

  /// Adds a note that explains a mark: Cell::marked(mark).
  Table& note(std::string mark, std::string text);

  /// Lets the table break over pages, with its heading on each. It then stands in no float, and
  /// `\tab[caption]{name}` gives it its caption.
  Table& break_over_pages();
  bool breaks_over_pages() const { return breaks_over_pages_; }

  const std::string& name() const { return name_; }
  const std::vector<Column>& columns() const { return columns_; }
  const std::vector<std::vector<Cell>>& rows() const { return rows_; }

  /// The index of the column with this heading and unit, «y (s)», in each of rows(). Throws
  /// std::invalid_argument, which names the headings, unless there is one such column.
  std::size_t column(const std::string& heading, Location location = Location::current()) const;
  const std::vector<TableNote>& notes() const { return notes_; }

  /// Throws std::invalid_argument for a mark without its note and a note without its mark.
  void require_complete() const;

  /// Writes the tabular, or the longtable of one that breaks over pages.
  std::string latex() const;

  /// Writes the table as HTML, in which LaTeX stands in <tex></tex>, and @use@ for its id.
  std::string html() const;

  /// Writes the table as CSV, with headings, texts and notes as plain_text() makes them and numbers
  /// that read back the same; a percentage is written as the ratio. A column whose numbers have
  /// errors is followed by one of error bounds, «abs_error», or of standard uncertainties,
  /// «standard», as import_csv reads them; notes stand at the end in lines that begin with #.
  std::string csv() const;

  /// The digits of each cell that holds a number, with the column's power of ten, by row and
  /// column.
  std::map<std::pair<std::size_t, std::size_t>, std::string> printed_numbers() const;

 private:
  std::string notes_latex() const;

  std::string name_;
  std::vector<Column> columns_;
  std::vector<std::vector<Cell>> rows_;
  std::vector<TableNote> notes_;
  bool breaks_over_pages_ = false;
  Location location_;
};

}  // namespace literate
