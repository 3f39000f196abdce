// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/tables/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "literate/tables/column_writer.hpp"

namespace literate {
namespace {

/// One line of the tabular, its cells joined by `&`.
template <typename CellText>
std::string line(const std::vector<ColumnWriter>& columns, CellText&& text) {
  std::vector<std::string> cells;
  for (const ColumnWriter& column : columns) cells.push_back(text(column));
  return fmt::format("  {} \\\\\n", fmt::join(cells, " & "));
}

std::string header(const std::vector<ColumnWriter>& columns) {
  std::string text = line(columns, [](const ColumnWriter& column) { return column.heading(); });
  const auto has_unit = [](const ColumnWriter& column) { return !column.unit().empty(); };
  if (std::ranges::any_of(columns, has_unit)) {
    text += line(columns, [](const ColumnWriter& column) { return column.unit(); });
  }
  return text;
}

}  // namespace

Table::Table(std::vector<Column> columns) : columns_(std::move(columns)) {
  if (columns_.empty()) throw std::invalid_argument("a table needs a column");
}

Table& Table::add_row(std::vector<Cell> cells) {
  if (cells.size() != columns_.size()) {
    throw std::invalid_argument(fmt::format("row {} of a table has {} cells for {} columns",
                                            rows_.size() + 1, cells.size(), columns_.size()));
  }
  rows_.push_back(std::move(cells));
  return *this;
}

std::vector<std::string> Table::headings() const {
  std::vector<std::string> headings;
  for (const Column& column : columns_) headings.push_back(column.format().heading);
  return headings;
}

std::string Table::latex() const {
  std::vector<ColumnWriter> columns;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    std::vector<const Cell*> cells;
    for (const auto& row : rows_) cells.push_back(&row[i]);
    columns.emplace_back(columns_[i].format(), cells);
  }
  std::string specification;
  for (const ColumnWriter& column : columns) specification += column.specification();

  std::string text = fmt::format("\\begin{{tabular}}{{{}}}\n  \\toprule\n", specification);
  text += header(columns) + "  \\midrule\n";
  for (std::size_t row = 0; row < rows_.size(); ++row) {
    text += line(columns, [row](const ColumnWriter& column) { return column.cell(row); });
  }
  return text + "  \\bottomrule\n\\end{tabular}\n";
}

std::string Table::csv() const {
  const auto quoted = [](std::string text) {
    for (std::size_t at = 0; (at = text.find('"', at)) != std::string::npos; at += 2) {
      text.insert(at, 1, '"');
    }
    return '"' + text + '"';
  };
  std::vector<std::string> line;
  for (const Column& column : columns_) {
    const auto& [heading, unit] = std::tie(column.format().heading, column.format().unit);
    line.push_back(quoted(unit.empty() ? heading : fmt::format("{} ({})", heading, unit)));
  }
  std::string text = fmt::format("{}\n", fmt::join(line, ","));
  for (const auto& row : rows_) {
    line.clear();
    for (const Cell& cell : row) {
      if (cell.is_empty()) {
        line.emplace_back();
      } else {
        line.push_back(cell.number() != nullptr ? fmt::format("{}", *cell.number())
                                                : quoted(*cell.text()));
      }
    }
    text += fmt::format("{}\n", fmt::join(line, ","));
  }
  return text;
}

}  // namespace literate
