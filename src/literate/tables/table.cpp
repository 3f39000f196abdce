// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/tables/table.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <set>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "literate/tables/column_writer.hpp"
#include "literate/text/latex.hpp"
#include "system/csv.hpp"
#include "system/text.hpp"

namespace literate {
namespace {

using Columns = std::vector<ColumnWriter>;

/// The columns with what their cells print.
Columns written(const std::vector<Column>& columns, const std::vector<std::vector<Cell>>& rows) {
  Columns writers;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    std::vector<const Cell*> cells;
    for (const auto& row : rows) cells.push_back(&row[i]);
    writers.emplace_back(columns[i].format(), cells);
  }
  return writers;
}

/// One line of the tabular, its cells joined by `&`.
template <typename CellText>
std::string line(const Columns& columns, CellText&& text) {
  std::vector<std::string> cells;
  for (const ColumnWriter& column : columns) cells.push_back(text(column));
  return fmt::format("  {} \\\\\n", fmt::join(cells, " & "));
}

/// The headings over several columns, each with a rule below; empty if there are none.
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

std::string header(const Columns& columns) {
  std::string text = spanning_headings(columns);
  text += line(columns, [](const ColumnWriter& column) { return column.heading(); });
  const auto has_unit = [](const ColumnWriter& column) { return !column.unit().empty(); };
  if (std::ranges::any_of(columns, has_unit)) {
    text += line(columns, [](const ColumnWriter& column) { return column.unit(); });
  }
  return text;
}

std::string code_place(const std::source_location& location) {
  return fmt::format("{}:{}", location.file_name(), location.line());
}

}  // namespace

Table::Table(std::string name, std::vector<Column> columns, Location location)
    : name_(std::move(name)), columns_(std::move(columns)), location_(location) {
  if (!columns_.empty()) return;
  throw std::invalid_argument(
      fmt::format("{}: table '{}' has no column", code_place(location), name_));
}

Table& Table::add_row(std::vector<Cell> cells, Location location) {
  const std::string row = fmt::format("{}: table '{}' (begun at {}), row {}", code_place(location),
                                      name_, code_place(location_), rows_.size() + 1);
  if (cells.size() != columns_.size()) {
    throw std::invalid_argument(
        fmt::format("{}: {} cells for {} columns", row, cells.size(), columns_.size()));
  }
  for (std::size_t i = 0; i < cells.size(); ++i) {
    try {
      require_printable(columns_[i].format(), cells[i]);
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(fmt::format("{}, column {} '{}': {}", row, i + 1,
                                              columns_[i].format().name(), error.what()));
    }
  }
  rows_.push_back(std::move(cells));
  return *this;
}

std::size_t Table::column(const std::string& heading, Location location) const {
  std::vector<std::string> headings;
  for (const Column& column : columns_) {
    const ColumnFormat& format = column.format();
    headings.push_back(format.unit.empty() ? format.name()
                                           : fmt::format("{} ({})", format.name(), format.unit));
  }
  const auto n_found = std::ranges::count(headings, heading);
  if (n_found == 1) {
    return static_cast<std::size_t>(std::ranges::find(headings, heading) - headings.begin());
  }
  const std::string at = fmt::format("{}: table '{}' has", code_place(location), name_);
  if (n_found > 1) {
    throw std::invalid_argument(fmt::format("{} {} columns '{}'", at, n_found, heading));
  }
  throw std::invalid_argument(
      fmt::format("{} no column '{}', but '{}'", at, heading, fmt::join(headings, "', '")));
}

Table& Table::note(std::string text) {
  return note("", std::move(text));
}

Table& Table::note(std::string mark, std::string text) {
  notes_.push_back({std::move(mark), std::move(text)});
  return *this;
}

Table& Table::break_over_pages() {
  breaks_over_pages_ = true;
  return *this;
}

void Table::require_complete() const {
  std::set<std::string> used, explained;
  for (const auto& row : rows_) {
    for (const Cell& cell : row) {
      if (!cell.mark().empty()) used.insert(cell.mark());
    }
  }
  for (const TableNote& note : notes_) {
    if (!note.mark.empty()) explained.insert(note.mark);
  }
  for (const std::string& mark : used) {
    if (explained.contains(mark)) continue;
    throw std::invalid_argument(fmt::format("{}: table '{}': no note explains the mark '{}'",
                                            code_place(location_), name_, mark));
  }
  for (const std::string& mark : explained) {
    if (used.contains(mark)) continue;
    throw std::invalid_argument(fmt::format("{}: table '{}': no cell has the mark '{}' of a note",
                                            code_place(location_), name_, mark));
  }
}

std::string Table::notes_latex() const {
  std::string text;
  for (const TableNote& note : notes_) {
    text += fmt::format("  \\LiterateNote{{{}}}{{{}}}\n", escape_latex(note.mark), note.text);
  }
  return text;
}

std::map<std::pair<std::size_t, std::size_t>, std::string> Table::printed_numbers() const {
  const Columns columns = written(columns_, rows_);
  std::map<std::pair<std::size_t, std::size_t>, std::string> printed;
  for (std::size_t row = 0; row < rows_.size(); ++row) {
    for (std::size_t column = 0; column < columns.size(); ++column) {
      if (rows_[row][column].number() == nullptr) continue;
      printed[{row, column}] = columns[column].printed(row);
    }
  }
  return printed;
}

std::string Table::latex() const {
  const Columns columns = written(columns_, rows_);
  std::string specification;
  for (const ColumnWriter& column : columns) specification += column.specification();
  std::string rows;
  for (std::size_t row = 0; row < rows_.size(); ++row) {
    rows += line(columns, [row](const ColumnWriter& column) { return column.cell(row); });
  }
  const std::string heading = fmt::format("  \\toprule\n{}  \\midrule\n", header(columns));

  if (breaks_over_pages_) {
    return fmt::format(
        "\\begin{{longtable}}{{{}}}\n  \\LiterateLongCaption\n{}  \\endfirsthead\n{}  \\endhead\n"
        "  \\midrule\n  \\multicolumn{{{}}}{{r}}{{\\LiterateContinued}} \\\\\n  \\endfoot\n"
        "  \\bottomrule\n  \\endlastfoot\n{}\\end{{longtable}}\n{}",
        specification, heading, heading, columns.size(), rows,
        notes_.empty()
            ? ""
            : fmt::format("\\begin{{LiterateNotes}}\n{}\\end{{LiterateNotes}}\n", notes_latex()));
  }
  const std::string tabular =
      fmt::format("\\begin{{tabular}}{{{}}}\n{}{}  \\bottomrule\n\\end{{tabular}}", specification,
                  heading, rows);
  if (notes_.empty()) return tabular + "\n";
  return fmt::format("\\LiterateNoted{{%\n{}}}{{%\n{}}}\n", tabular, notes_latex());
}

namespace {

// The lines of the head: the headings over several columns, the headings, the units.
std::string head_html(const Columns& columns) {
  std::string groups, headings, units;
  bool has_groups = false, has_units = false;
  for (std::size_t first = 0; first < columns.size();) {
    const std::string& group = columns[first].group();
    std::size_t end = first + 1;
    while (!group.empty() && end < columns.size() && columns[end].group() == group) ++end;
    has_groups = has_groups || !group.empty();
    groups += group.empty()
                  ? "<td></td>"
                  : fmt::format("<th colspan=\"{}\" scope=\"colgroup\"><tex>{}</tex></th>",
                                end - first, group);
    first = end;
  }
  for (const ColumnWriter& column : columns) {
    const std::string kind = column.html_class();
    const char* cell = column.heading().empty() ? "td" : "th scope=\"col\"";
    headings += fmt::format("<{}{}><tex>{}</tex></{}>", cell, kind, column.heading(),
                            std::string_view(cell).substr(0, 2));
    has_units = has_units || !column.unit().empty();
    units += fmt::format("<td{}><tex>{}</tex></td>", kind, column.unit());
  }
  return (has_groups ? "<tr>" + groups + "</tr>\n" : "") + "<tr>" + headings + "</tr>\n" +
         (has_units ? "<tr>" + units + "</tr>\n" : "");
}

}  // namespace

std::string Table::html() const {
  const Columns columns = written(columns_, rows_);
  std::string text = fmt::format(
      "<div class=\"lit-scroll\" tabindex=\"0\" role=\"group\" aria-label=\"table {0}\">"
      "<table class=\"lit-table\" id=\"@use@\" "
      "data-table=\"{0}\">\n<thead>\n{1}</thead>\n<tbody>\n",
      name_, head_html(columns));
  for (std::size_t row = 0; row < rows_.size(); ++row) {
    text += "<tr>";
    for (const ColumnWriter& column : columns) text += column.cell_html(row);
    text += "</tr>\n";
  }
  text += "</tbody>\n</table></div>\n";
  for (const TableNote& note : notes_) {
    text += fmt::format("<p class=\"lit-table-note\">{}<tex>{}</tex></p>\n",
                        note.mark.empty() ? "" : "<sup>" + note.mark + "</sup> ", note.text);
  }
  return text;
}

std::string csv_heading(const ColumnFormat& format) {
  const std::string group = format.group.empty() ? "" : plain_text(format.group) + ": ";
  const std::string unit = format.unit.empty() ? "" : fmt::format(" ({})", format.unit);
  return group + (format.plain.empty() ? plain_text(format.heading) : format.plain) + unit;
}

namespace {

std::string csv_cell(const Cell& cell) {
  if (cell.is_empty()) return "";
  if (cell.number() != nullptr) return fmt::format("{}", *cell.number());
  return sys::one_line(cell.plain().empty() ? plain_text(*cell.text()) : cell.plain());
}

/// A column of errors, and whether one of some uncertainty belongs there.
struct ErrorColumn {
  const char* heading;
  bool (*has)(const Uncertainty&);
  double (*number)(const Uncertainty&);
};
constexpr std::array<ErrorColumn, 4> error_columns{
    {{"abs_error", [](const Uncertainty& u) { return u.told_bound() > 0; },
      [](const Uncertainty& u) { return u.told_bound(); }},
     {"below", [](const Uncertainty& u) { return u.sides.has_value(); },
      [](const Uncertainty& u) { return u.sides ? u.sides->first : u.told_bound(); }},
     {"above", [](const Uncertainty& u) { return u.sides.has_value(); },
      [](const Uncertainty& u) { return u.sides ? u.sides->second : u.told_bound(); }},
     {"standard", [](const Uncertainty& u) { return u.standard > 0; },
      [](const Uncertainty& u) { return u.standard; }}}};

/// Which of them a column of the table has.
std::vector<ErrorColumn> errors_in(const std::vector<std::vector<Cell>>& rows, std::size_t column) {
  std::vector<ErrorColumn> errors;
  for (const ErrorColumn& error : error_columns) {
    const bool has_any = std::ranges::any_of(
        rows, [&](const auto& row) { return error.has(row[column].uncertainty().value_or(0)); });
    if (has_any) errors.push_back(error);
  }
  // Bounds to either side say all that one to both does.
  const bool has_sides = std::ranges::any_of(
      errors, [](const ErrorColumn& error) { return error.heading == std::string_view("below"); });
  if (has_sides) errors.erase(errors.begin());
  return errors;
}

/// A bare number is exact; only of one that is quoted without an error none is known.
std::string csv_error(const ErrorColumn& error, const Cell& cell) {
  if (cell.number() == nullptr || (cell.place() && !cell.uncertainty())) return "";
  return fmt::format("{}", error.number(cell.uncertainty().value_or(0)));
}

}  // namespace

std::string Table::csv() const {
  std::vector<std::vector<ErrorColumn>> errors;
  std::vector<std::string> fields;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    fields.push_back(csv_heading(columns_[i].format()));
    errors.push_back(errors_in(rows_, i));
    for (const ErrorColumn& error : errors.back()) fields.emplace_back(error.heading);
  }
  std::string text = sys::csv_line(fields);
  std::string marks;
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    fields.clear();
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      const Cell& cell = rows_[r][i];
      fields.push_back(csv_cell(cell));
      for (const ErrorColumn& error : errors[i]) fields.push_back(csv_error(error, cell));
      if (!cell.mark().empty()) {
        marks += fmt::format("# row {}, column {}: {}\n", r + 1, i + 1, cell.mark());
      }
    }
    text += sys::csv_line(fields);
  }
  text += marks;
  for (const TableNote& note : notes_) {
    text += fmt::format("# {}{}{}\n", note.mark, note.mark.empty() ? "" : ": ",
                        sys::one_line(plain_text(note.text)));
  }
  return text;
}

}  // namespace literate
