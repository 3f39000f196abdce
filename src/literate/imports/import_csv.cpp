// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/imports/import_csv.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "literate/imports/imported_table.hpp"
#include "literate/text/characters.hpp"
#include "literate/text/latex.hpp"
#include "system/csv.hpp"
#include "system/nearest_name.hpp"
#include "system/pattern.hpp"
#include "system/text.hpp"

namespace literate {
namespace fs = std::filesystem;
namespace {

/// A CSV file that becomes a table, and the places in it for messages.
struct CsvSource {
  std::string file;
  std::string table;

  std::string at(unsigned line) const {
    return fmt::format("{}:{}: table '{}'", file, line, table);
  }
  std::string at(const sys::CsvField& field) const {
    return fmt::format("{}: table '{}'", field.place, table);
  }
};

/// Which fields of a line are cells of one printed column.
struct Fields {
  std::size_t number = 0;
  std::map<std::string, std::size_t> errors = {};
};

/// Whether a column of this heading holds the errors of the column to its left.
bool holds_errors(const std::string& heading, const ImportOptions& options) {
  const bool is_side = heading == "below" || heading == "above";
  return heading == "abs_error" || heading == "standard" ||
         (is_side && !options.exact.contains(heading) && !options.text.contains(heading));
}

/// Declares columns as the options do by their headings.
void declare(std::vector<ImportedColumn>& columns, const CsvSource& source,
             const sys::CsvRow& heading, const std::vector<Fields>& fields,
             const ImportOptions& options) {
  std::set<std::string> known;
  for (const sys::CsvField& field : heading) known.insert(field.text);
  const auto require_known = [&](const std::set<std::string>& names, const char* what) {
    for (const std::string& name : names) {
      if (known.contains(name)) continue;
      throw ImportError(fmt::format("{}: there is no column '{}', which is to be {}{}",
                                    source.at(heading[0].line), name, what,
                                    sys::suggestion(name, known)));
    }
  };
  require_known(options.exact, "exact");
  require_known(options.uncertain, "uncertain");
  require_known(options.text, "of texts");
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const sys::CsvField& field = heading[fields[i].number];
    const std::string& name = field.text;
    const bool is_text = options.text.contains(name);
    columns[i].is_exact = options.exact.contains(name);
    if (options.uncertain.contains(name)) columns[i].format = uncertain();
    columns[i].is_text = is_text;
    if (is_text && !fields[i].errors.empty()) {
      throw ImportError(
          fmt::format("{}: column '{}' is of texts and has errors", source.at(field), name));
    }
    const std::string suggestion = sys::suggestion(name, {"abs_error", "standard"});
    if (columns[i].is_exact || is_text || suggestion.empty()) continue;
    throw ImportError(fmt::format("{}: column '{}'{}", source.at(field), name, suggestion));
  }
}

std::vector<Fields> fields_of(const CsvSource& source, const sys::CsvRow& heading,
                              const ImportOptions& options) {
  std::vector<Fields> columns;
  std::set<std::string> names;
  for (std::size_t i = 0; i < heading.size(); ++i) {
    const std::string& name = heading[i].text;
    if (!holds_errors(name, options)) {
      if (!names.insert(name).second) {
        throw ImportError(fmt::format("{}: column '{}' stands twice", source.at(heading[i]), name));
      }
      columns.push_back({i});
    } else if (columns.empty() || !columns.back().errors.emplace(name, i).second) {
      throw ImportError(
          fmt::format("{}: {} has no column of numbers to its left", source.at(heading[i]), name));
    }
  }
  return columns;
}

/// The columns with heading and unit, which «x (in)» has.
std::vector<ImportedColumn> columns_of(const CsvSource& source, const sys::CsvRow& heading,
                                       const std::vector<Fields>& fields) {
  std::vector<ImportedColumn> columns;
  for (const Fields& of_column : fields) {
    const std::string& name = heading[of_column.number].text;
    const std::string at = source.at(heading[of_column.number]);
    const auto parenthesis = name.rfind(" (");
    if (parenthesis == name.npos || !name.ends_with(')')) {
      if (parenthesis != name.npos && name.find(')', parenthesis) == name.npos) {
        throw ImportError(
            fmt::format("{}: column '{}': the parenthesis of its unit is not closed", at, name));
      }
      columns.push_back({.plain = name, .at = at});
    } else {
      columns.push_back({.plain = name.substr(0, parenthesis),
                         .unit = name.substr(parenthesis + 2, name.size() - parenthesis - 3),
                         .at = at});
    }
    columns.back().heading = escape_latex(columns.back().plain);
  }
  return columns;
}

ImportedCell cell_of(const CsvSource& source, const sys::CsvRow& row, const Fields& fields,
                     bool is_text) {
  const std::string& text = row[fields.number].text;
  ImportedCell cell{.at = source.at(row[fields.number])};
  if (text.empty()) {
    for (const auto& [name, column] : fields.errors) {
      if (row[column].text.empty()) continue;
      throw ImportError(fmt::format("{}: {} '{}' belongs to no number: the cell is empty",
                                    source.at(row[column]), name, row[column].text));
    }
    return cell;
  }
  const auto number = written_number(text);
  if (number && !is_text) {
    cell.content = *number;
  } else {
    cell.content = text;
  }
  for (const auto& [name, column] : fields.errors) {
    if (row[column].text.empty()) continue;
    const auto error = written_number(row[column].text);
    if (!error) {
      throw ImportError(fmt::format("{}: {} '{}' is not a number", source.at(row[column]), name,
                                    row[column].text));
    }
    if (!std::isfinite(error->number) || error->number < 0) {
      throw ImportError(fmt::format("{}: {} = {}: must be finite and not negative",
                                    source.at(row[column]), name, row[column].text));
    }
    cell.errors[name] = error->number;
  }
  return cell;
}

/// Whether programs write infinities or what is no number so: a column of these alone is none of
/// texts.
bool is_not_finite(std::string_view text) {
  static const sys::Pattern spelt("^[-+]?(nan|inf|infinity|NaN|NAN|Inf|INF|Infinity)$");
  return spelt.find_in(text).has_value();
}

bool holds_a_number(const std::vector<sys::CsvRow>& rows, const Fields& fields) {
  if (!fields.errors.empty()) return true;
  return std::any_of(rows.begin() + 1, rows.end(), [&fields](const sys::CsvRow& row) {
    const std::string& text = row[fields.number].text;
    return written_number(text).has_value() || is_not_finite(text);
  });
}

/// A column of texts has no unit: what stands in parentheses is of its heading. One that holds
/// texts and was to be exact is refused.
void keep_heading(ImportedColumn& column, const CsvSource& source,
                  const std::vector<sys::CsvRow>& rows, const Fields& fields) {
  const std::string& name = rows.front()[fields.number].text;
  if (column.is_exact && rows.size() > 1) {
    const sys::CsvField& first = rows[1][fields.number];
    throw ImportError(fmt::format("{}: '{}' is not a number, and column '{}' is to be exact",
                                  source.at(first), first.text, name));
  }
  column.unit.clear();
  column.plain = name;
  column.heading = escape_latex(name);
}

/// Throws SourceError at the first field with a byte that is no UTF-8.
void require_utf8(const std::vector<sys::CsvRow>& rows) {
  for (const sys::CsvRow& row : rows) {
    for (const sys::CsvField& field : row) {
      for (std::string_view rest = field.text; !rest.empty();) {
        const sys::Utf8Character next = sys::first_character(rest);
        if (!next.code_point) throw sys::SourceError(field.place + ": this text is not UTF-8");
        rest.remove_prefix(next.bytes.size());
      }
    }
  }
}

struct ReadFiles {
  NumbersAndScript sources;
  std::vector<sys::CsvRow> rows;
};

ReadFiles read_files(const fs::path& file, const fs::path& script, const fs::path& root,
                     const std::string& table) {
  try {
    NumbersAndScript sources = with_script(file, read_numbers(file), script, root);
    auto rows = sys::parse_csv(sources.numbers.text, file.string(), sys::CsvComments::number_sign);
    require_utf8(rows);
    return {std::move(sources), std::move(rows)};
  } catch (const sys::InputError& error) {
    throw ImportError(fmt::format("{}, for table '{}'", error.what(), table));
  }
}

}  // namespace

void import_csv(Document& document, const std::string& name, const fs::path& file_path,
                const fs::path& script, const ImportOptions& options) {
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

  const auto [sources, rows] = read_files(file_path, script, options.root, key);
  const CsvSource source{file, key};
  if (rows.empty()) {
    throw ImportError(fmt::format("{}: there is no line of headings", source.at(1)));
  }
  const std::vector<Fields> fields = fields_of(source, rows.front(), options);
  std::vector<ImportedColumn> columns = columns_of(source, rows.front(), fields);
  declare(columns, source, rows.front(), fields, options);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (!holds_a_number(rows, fields[i])) columns[i].is_text = true;
    if (columns[i].is_text) keep_heading(columns[i], source, rows, fields[i]);
  }

  std::vector<std::vector<ImportedCell>> cells;
  for (auto row = rows.begin() + 1; row != rows.end(); ++row) {
    cells.emplace_back();
    for (std::size_t i = 0; i < columns.size(); ++i) {
      cells.back().push_back(cell_of(source, *row, fields[i], columns[i].is_text));
    }
  }
  Table table = table_of(key, columns, cells, source.at(rows.front()[0].line));

  document.attach(sources.numbers);
  document.attach(sources.script);
  document.table(std::move(table),
                 SourcePlace{sources.numbers.name, sources.script.name, rows.front()[0].line});
}

}  // namespace literate
