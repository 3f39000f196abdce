// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/tables/table.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "literate/tables/printed_column.hpp"
#include "literate/text/latex.hpp"
#include "literate/values/decimal.hpp"
#include "system/text.hpp"

namespace literate {
namespace {

using Columns = std::vector<PrintedColumn>;

Columns printed_columns(const Table& table) {
  Columns columns;
  for (std::size_t i = 0; i < table.columns().size(); ++i) {
    std::vector<const Cell*> cells;
    for (const auto& row : table.rows()) cells.push_back(&row[i]);
    columns.emplace_back(table.columns()[i], cells);
  }
  return columns;
}

/// One line of the tabular. The empty group in front keeps LaTeX from reading a cell that begins
/// with [ or * as an argument of the rule or the \\ before it.
template <typename CellText>
std::string line(const Columns& columns, CellText&& text) {
  std::vector<std::string> cells;
  for (const PrintedColumn& column : columns) cells.push_back(text(column));
  return fmt::format("  {{}}{} \\\\\n", fmt::join(cells, " & "));
}

/// The headings that span several columns, each with a rule below it; empty if there are none.
std::string spanning_headings(const Columns& columns) {
  std::vector<std::string> cells, rules;
  for (std::size_t first = 0; first < columns.size();) {
    const std::string& group = columns[first].group();
    std::size_t end = first + 1;
    while (!group.empty() && end < columns.size() && columns[end].group() == group) ++end;
    if (group.empty()) {
      cells.emplace_back();
    } else {
      cells.push_back(fmt::format("\\multicolumn{{{}}}{{c}}{{{}}}", end - first, group));
      rules.push_back(fmt::format("\\cmidrule(lr){{{}-{}}}", first + 1, end));
    }
    first = end;
  }
  if (rules.empty()) return "";
  return fmt::format("  {} \\\\\n  {}\n", fmt::join(cells, " & "), fmt::join(rules, " "));
}

std::string head(const Columns& columns) {
  std::string text = spanning_headings(columns);
  text += line(columns, [](const PrintedColumn& column) { return column.heading(); });
  const auto has_unit = [](const PrintedColumn& column) { return !column.unit().empty(); };
  if (std::ranges::any_of(columns, has_unit)) {
    text += line(columns, [](const PrintedColumn& column) { return column.unit(); });
  }
  return text;
}

}  // namespace

Table::Table(std::string name, std::vector<Column> columns, const Place& place)
    : name_(std::move(name)), columns_(std::move(columns)) {
  if (columns_.empty()) fail_at(place, fmt::format("table '{}' has no column", name_));
}

Table& Table::add_row(std::vector<Cell> cells, const Place& place) {
  const std::string row = fmt::format("table '{}', row {}", name_, rows_.size() + 1);
  if (cells.size() != columns_.size()) {
    fail_at(place, fmt::format("{}: {} cells for {} columns", row, cells.size(), columns_.size()));
  }
  for (std::size_t i = 0; i < cells.size(); ++i) {
    try {
      require_printable(columns_[i], cells[i]);
    } catch (const std::invalid_argument& error) {
      fail_at(place, fmt::format("{}, column {} '{}': {}", row, i + 1, columns_[i].heading(),
                                 error.what()));
    }
  }
  rows_.push_back(std::move(cells));
  return *this;
}

Table& Table::note(std::string text, const Place& place) {
  try {
    notes_.push_back(author_latex(text));
  } catch (const std::invalid_argument& error) {
    fail_at(place, fmt::format("table '{}', note: {}", name_, error.what()));
  }
  return *this;
}

std::string Table::latex() const {
  const Columns columns = printed_columns(*this);
  std::string specification, rows;
  for (const PrintedColumn& column : columns) specification += column.specification();
  for (std::size_t row = 0; row < rows_.size(); ++row) {
    rows += line(columns, [row](const PrintedColumn& column) { return column.cell(row); });
  }
  const std::string tabular = fmt::format(
      "\\begin{{tabular}}{{{}}}\n  \\toprule\n{}  \\midrule\n{}  \\bottomrule\n"
      "\\end{{tabular}}",
      specification, head(columns), rows);
  if (notes_.empty()) return tabular + "%\n";
  std::string notes;
  for (const std::string& note : notes_) notes += fmt::format("\\LiterateNote{{{}}}%\n", note);
  return fmt::format("\\LiterateNoted{{%\n{}}}{{%\n{}}}%\n", tabular, notes);
}

std::vector<std::vector<std::string>> Table::printed() const {
  const Columns columns = printed_columns(*this);
  std::vector<std::vector<std::string>> rows(rows_.size());
  for (std::size_t row = 0; row < rows.size(); ++row) {
    for (const PrintedColumn& column : columns) rows[row].push_back(column.plain(row));
  }
  return rows;
}

std::string Table::csv() const {
  // The columns of errors that follow a column.
  struct Errors {
    bool has_bound = false, has_standard = false;
  };
  std::vector<Errors> errors(columns_.size());
  std::vector<std::string> fields;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const Column& column = columns_[i];
    for (const auto& row : rows_) {
      const auto& known = row[i].known();
      errors[i].has_bound = errors[i].has_bound || (known && known->bound > 0);
      errors[i].has_standard = errors[i].has_standard || (known && known->standard > 0);
    }
    const std::string group = column.group().empty() ? "" : column.group() + ": ";
    const std::string unit = column.unit().empty() ? "" : fmt::format(" ({})", column.unit());
    fields.push_back(group + column.heading() + unit);
    if (errors[i].has_bound) fields.emplace_back("bound");
    if (errors[i].has_standard) fields.emplace_back("standard");
  }
  std::string text = sys::csv_line(fields);
  for (const auto& row : rows_) {
    fields.clear();
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      const Cell& cell = row[i];
      const bool is_number = cell.number() != nullptr;
      fields.push_back(is_number ? round_trip(*cell.number()) : sys::one_line(cell.given()));
      const bool is_known = is_number && cell.known();
      if (errors[i].has_bound) fields.push_back(is_known ? round_trip(cell.known()->bound) : "");
      if (errors[i].has_standard) {
        fields.push_back(is_known ? round_trip(cell.known()->standard) : "");
      }
    }
    text += sys::csv_line(fields);
  }
  for (const std::string& note : notes_) text += fmt::format("# {}\n", sys::one_line(note));
  return text;
}

}  // namespace literate
