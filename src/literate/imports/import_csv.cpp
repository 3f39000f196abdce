// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/imports/import_csv.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "literate/imports/csv_file.hpp"
#include "literate/imports/import_error.hpp"
#include "literate/imports/source_files.hpp"
#include "literate/text/latex.hpp"
#include "literate/text/name.hpp"
#include "system/nearest_name.hpp"
#include "system/pattern.hpp"

namespace literate {
namespace fs = std::filesystem;
namespace {

/// Which fields of a line are cells of one printed column.
struct Fields {
  std::size_t number = 0;
  std::optional<std::size_t> abs_error = {};
};

/// Splits «x (in)» into a heading for LaTeX and a unit.
ImportedColumn column_of(const std::string& field) {
  ImportedColumn column;
  const auto parenthesis = field.rfind(" (");
  if (parenthesis == std::string::npos || !field.ends_with(')')) {
    column.heading = escape_latex(field);
  } else {
    column.heading = escape_latex(field.substr(0, parenthesis));
    column.unit = field.substr(parenthesis + 2, field.size() - parenthesis - 3);
  }
  return column;
}

/// Declares the columns exact whose headings are named.
void declare_exact(std::vector<ImportedColumn>& columns, const CsvSource& source,
                   const CsvRow& heading, const std::vector<Fields>& fields,
                   const std::set<std::string>& exact) {
  for (const std::string& name : exact) {
    const auto& headings = heading.fields;
    if (std::ranges::find(headings, name) != headings.end()) continue;
    throw ImportError(fmt::format("{}: there is no column '{}', which is to be exact{}",
                                  source.at(heading.line), name,
                                  sys::suggestion(name, {headings.begin(), headings.end()})));
  }
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const std::string& name = heading.fields[fields[i].number];
    columns[i].is_exact = columns[i].is_exact || exact.contains(name);
    const std::string suggestion = sys::suggestion(name, {"abs_error"});
    if (columns[i].is_exact || suggestion.empty()) continue;
    throw ImportError(fmt::format("{}: column '{}'{}",
                                  source.at(heading.line, fields[i].number + 1), name, suggestion));
  }
}

std::vector<Fields> fields_of(const CsvSource& source, const CsvRow& heading) {
  std::vector<Fields> columns;
  for (std::size_t i = 0; i < heading.fields.size(); ++i) {
    if (heading.fields[i] != "abs_error") {
      columns.push_back({i});
    } else if (columns.empty() || columns.back().abs_error) {
      throw ImportError(fmt::format("{}: abs_error has no column of numbers to its left",
                                    source.at(heading.line, i + 1)));
    } else {
      columns.back().abs_error = i;
    }
  }
  return columns;
}

/// Takes headings and units from the file where the caller has given none.
void complete(std::vector<ImportedColumn>& columns, const CsvSource& source, const CsvRow& heading,
              const std::vector<Fields>& fields) {
  const bool are_given = !columns.empty();
  if (are_given && columns.size() != fields.size()) {
    throw ImportError(fmt::format("{}: {} columns, where {} are described", source.at(heading.line),
                                  fields.size(), columns.size()));
  }
  columns.resize(fields.size());
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const ImportedColumn from_file = column_of(heading.fields[fields[i].number]);
    if (columns[i].heading.empty()) columns[i].heading = from_file.heading;
    if (columns[i].unit.empty()) columns[i].unit = from_file.unit;
    columns[i].at = source.at(heading.line, fields[i].number + 1);
  }
}

ImportedCell cell_of(const CsvSource& source, const CsvRow& row, const Fields& fields,
                     bool is_text) {
  const std::string& text = row.fields[fields.number];
  ImportedCell cell{.at = source.at(row.line, fields.number + 1)};
  if (text.empty()) return cell;
  const auto number = written_number(text);
  if (number && !is_text) {
    cell.content = *number;
  } else {
    cell.content = text;
  }
  if (!fields.abs_error || row.fields[*fields.abs_error].empty()) return cell;
  const auto error = written_number(row.fields[*fields.abs_error]);
  if (!error) {
    throw ImportError(fmt::format("{}: abs_error '{}' is not a number",
                                  source.at(row.line, *fields.abs_error + 1),
                                  row.fields[*fields.abs_error]));
  }
  cell.abs_error = error->number;
  return cell;
}

/// Whether programs write infinities or what is no number so: a column of these alone is none of
/// texts.
bool is_not_finite(std::string_view text) {
  static const sys::Pattern spelt("^[-+]?(nan|inf|infinity|NaN|NAN|Inf|INF|Infinity)$");
  return spelt.find_in(text).has_value();
}

bool holds_a_number(const std::vector<CsvRow>& rows, const Fields& fields) {
  if (fields.abs_error) return true;
  return std::any_of(rows.begin() + 1, rows.end(), [&fields](const CsvRow& row) {
    const std::string& text = row.fields[fields.number];
    return written_number(text).has_value() || is_not_finite(text);
  });
}

NumbersAndScript read_files(const fs::path& file, const fs::path& script, const fs::path& root,
                            const std::string& table) {
  try {
    return with_script(file, read_numbers(file), script, root);
  } catch (const ImportError& error) {
    throw ImportError(fmt::format("{}, for table '{}'", error.what(), table));
  }
}

}  // namespace

void import_csv(Document& document, const std::string& name, const fs::path& file_path,
                const fs::path& script, std::vector<ImportedColumn> columns,
                const ImportOptions& options) {
  const std::string file = file_path.string();
  const std::string key = options.prefix + name;
  if (!is_file_name(key)) {
    throw ImportError(
        fmt::format("{}: the table's name '{}' must be letters, digits, '-' and '_'", file, key));
  }
  if (document.tables().contains(key)) {
    throw ImportError(fmt::format("{}: table '{}' is registered already, at {}", file, key,
                                  text_of(document.registered().places.at({"table", key}))));
  }

  const NumbersAndScript sources = read_files(file_path, script, options.root, key);
  const CsvSource source{file, key};
  const std::vector<CsvRow> rows = csv_rows(source, sources.numbers.text);
  if (rows.empty()) {
    throw ImportError(fmt::format("{}: there is no line of headings", source.at(1)));
  }
  const std::vector<Fields> fields = fields_of(source, rows.front());
  complete(columns, source, rows.front(), fields);
  declare_exact(columns, source, rows.front(), fields, options.exact);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const bool keeps_digits = columns[i].format == NumberFormat::as_written;
    if (keeps_digits && !holds_a_number(rows, fields[i])) {
      columns[i].format = NumberFormat::text;
    }
  }

  std::vector<std::vector<ImportedCell>> cells;
  for (auto row = rows.begin() + 1; row != rows.end(); ++row) {
    cells.emplace_back();
    for (std::size_t i = 0; i < columns.size(); ++i) {
      cells.back().push_back(
          cell_of(source, *row, fields[i], columns[i].format == NumberFormat::text));
    }
  }
  Table table = table_of(key, columns, cells, source.at(rows.front().line));

  document.attach(sources.numbers);
  document.attach(sources.script);
  document.table(std::move(table),
                 SourcePlace{sources.numbers.name, sources.script.name, rows.front().line});
}

}  // namespace literate
