// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/imports/import_json.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>
#include <json/reader.h>
#include <json/value.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include "literate/imports/imported_table.hpp"
#include "literate/text/characters.hpp"
#include "system/files.hpp"
#include "system/text.hpp"

namespace literate {
namespace fs = std::filesystem;
namespace {

struct Position {
  unsigned line = 1;
  unsigned column = 1;
};

Position position_in(const std::string& text, std::ptrdiff_t offset) {
  const auto end = text.begin() + offset;
  const auto n_before = std::count(text.begin(), end, '\n');
  const auto line_begin = std::find(std::reverse_iterator(end), text.rend(), '\n').base();
  return {static_cast<unsigned>(n_before + 1), static_cast<unsigned>(end - line_begin + 1)};
}

/// What the library says of the first error, «* Line 3, Column 7» and a line with the message.
ImportError syntax_error(const fs::path& file, const std::string& said) {
  const auto lines = sys::lines_of(said);
  Position at;
  if (lines.size() < 2 ||
      std::sscanf(said.c_str(), "* Line %u, Column %u", &at.line, &at.column) != 2) {
    return ImportError(fmt::format("{}: is not JSON: {}", file.string(), said));
  }
  return ImportError(fmt::format("{}:{}:{}: is not JSON: {}", file.string(), at.line, at.column,
                                 sys::stripped(lines[1])));
}

/// A JSON file whose values know where they stand. Columns count bytes.
class JsonFile {
 public:
  /// Reads JSON without NaN and without a key twice in an object. Throws ImportError
  /// «file:line:column: message».
  explicit JsonFile(const fs::path& file) : file_(file), text_(read_numbers(file)) {
    Json::CharReaderBuilder strict;
    Json::CharReaderBuilder::strictMode(&strict.settings_);
    const std::unique_ptr<Json::CharReader> reader(strict.newCharReader());
    std::string said;
    try {
      if (reader->parse(text_.data(), text_.data() + text_.size(), &root_, &said)) return;
    } catch (const Json::Exception& error) {  // what is nested too deeply
      said = error.what();
    }
    throw syntax_error(file, said);
  }

  const std::string& text() const { return text_; }
  const Json::Value& root() const { return root_; }

  /// The line of a value, counted from 1.
  unsigned line(const Json::Value& value) const {
    return position_in(text_, value.getOffsetStart()).line;
  }

  /// «file:line:column» of a value.
  std::string at(const Json::Value& value) const {
    const Position position = position_in(text_, value.getOffsetStart());
    return fmt::format("{}:{}:{}", file_.string(), position.line, position.column);
  }

  /// A number as it is written in the file.
  std::string_view written(const Json::Value& value) const {
    const auto start = static_cast<std::size_t>(value.getOffsetStart());
    const auto limit = static_cast<std::size_t>(value.getOffsetLimit());
    return std::string_view(text_).substr(start, limit - start);
  }

  /// Throws ImportError at a value.
  [[noreturn]] void fail(const Json::Value& value, const std::string& message) const {
    throw ImportError(fmt::format("{}: {}", at(value), message));
  }

  /// Throws ImportError unless `value` is an object with no other fields than these; `what` says
  /// what it describes.
  void require_fields(const Json::Value& value, const std::string& what,
                      const std::vector<std::string>& allowed) const {
    if (!value.isObject()) fail(value, what + " must be an object");
    for (const std::string& field : value.getMemberNames()) {
      if (std::ranges::find(allowed, field) != allowed.end()) continue;
      fail(value[field], fmt::format("{} has an unknown field '{}'; known are {}", what, field,
                                     fmt::join(allowed, ", ")));
    }
  }

 private:
  fs::path file_;
  std::string text_;
  Json::Value root_;
};

std::string text_field(const JsonFile& file, const Json::Value& object, const std::string& what,
                       const std::string& field) {
  if (!object.isMember(field)) file.fail(object, fmt::format("{} has no {}", what, field));
  const Json::Value& value = object[field];
  if (!value.isString()) file.fail(value, fmt::format("{}: {} must be a text", what, field));
  return value.asString();
}

std::string unit_field(const JsonFile& file, const Json::Value& object, const std::string& what) {
  return object.isMember("unit") ? text_field(file, object, what, "unit") : "";
}

WrittenNumber number_field(const JsonFile& file, const Json::Value& object, const std::string& what,
                           const std::string& field) {
  if (!object.isMember(field)) file.fail(object, fmt::format("{} has no {}", what, field));
  const Json::Value& value = object[field];
  if (value.isNull()) {
    file.fail(value,
              fmt::format("{}: {} is null, as programs write NaN: it must be a finite number", what,
                          field));
  }
  const auto written = value.isNumeric() ? written_number(file.written(value)) : std::nullopt;
  if (!written || !std::isfinite(written->number)) {
    file.fail(value, fmt::format("{}: {} must be a finite number", what, field));
  }
  return *written;
}

int whole_field(const JsonFile& file, const Json::Value& object, const std::string& what,
                const std::string& field, int least, int most) {
  const Json::Value& value = object[field];
  if (!value.isInt() || value.asInt() < least || value.asInt() > most) {
    file.fail(value, fmt::format("{}: {} = {} must be a whole number from {} to {}", what, field,
                                 file.written(value), least, most));
  }
  return value.asInt();
}

/// An abs_error, a standard uncertainty, or both.
Uncertainty uncertainty_field(const JsonFile& file, const Json::Value& object,
                              const std::string& what) {
  const auto field = [&](const char* name) {
    const double error = number_field(file, object, what, name).number;
    if (error < 0) file.fail(object[name], fmt::format("{}: {} must not be negative", what, name));
    return error;
  };
  if (!object.isMember("standard")) return field("abs_error");
  Uncertainty uncertainty(object.isMember("abs_error") ? field("abs_error") : 0);
  uncertainty.standard = field("standard");
  return uncertainty;
}

constexpr int max_digits = 100;
using numerics::Measured;

Value value_of(const JsonFile& file, const Json::Value& entry, const std::string& what) {
  if (entry.isObject() && entry.isMember("text")) {
    file.require_fields(entry, what, {"text"});
    return Value::text(text_field(file, entry, what, "text"));
  }
  file.require_fields(entry, what, {"value", "abs_error", "standard", "unit", "digits"});
  const WrittenNumber written = number_field(file, entry, what, "value");
  const double number = written.number;
  const Uncertainty uncertainty = uncertainty_field(file, entry, what);
  if (!is_held(written, uncertainty.error())) {
    file.fail(entry["value"],
              fmt::format("{}: {} has more digits than a number holds: give its error, or a text",
                          what, written.text));
  }
  // What a script says of a number is a source of its own.
  const Measured measured =
      Measured(number, uncertainty.standard, what) + Measured::bounded({0, uncertainty.bound});
  const std::string unit = unit_field(file, entry, what);
  try {
    const bool is_exact = uncertainty.error() == 0;
    if (!entry.isMember("digits")) return Value(measured, is_exact ? exact() : supported(), unit);
    const int digits = whole_field(file, entry, what, "digits", 1, max_digits);
    const Value wanted(number, significant(digits), unit);
    require_earned(number, wanted.last_place(), uncertainty.error(), wanted.printed());
    return Value(measured, significant(digits), unit);
  } catch (const std::invalid_argument& reason) {
    file.fail(entry, fmt::format("{}: {}", what, reason.what()));
  }
}

ImportedColumn column_of(const JsonFile& file, const Json::Value& entry, const std::string& what) {
  file.require_fields(entry, what,
                      {"heading", "unit", "decimals", "exponent", "digits", "integer", "uncertain",
                       "text", "exact"});
  ImportedColumn column{.heading = text_field(file, entry, what, "heading"),
                        .unit = unit_field(file, entry, what)};
  const auto is_true = [&](const char* field) {
    if (!entry.isMember(field)) return false;
    if (!entry[field].isBool() || !entry[field].asBool()) {
      file.fail(entry[field], fmt::format("{}: {} can only be true", what, field));
    }
    return true;
  };
  column.is_exact = is_true("exact");
  column.is_text = is_true("text");
  std::vector<Format> formats;
  if (is_true("integer")) formats.push_back(integer());
  if (is_true("uncertain")) formats.push_back(uncertain());
  if (entry.isMember("decimals")) {
    formats.push_back(fixed(whole_field(file, entry, what, "decimals", 0, max_digits)));
  }
  if (entry.isMember("digits")) {
    formats.push_back(scientific(whole_field(file, entry, what, "digits", 1, max_digits)));
  }
  if (formats.size() + (column.is_text ? 1 : 0) > 1) {
    file.fail(entry, what + " has more than one of decimals, digits, integer, uncertain, text");
  }
  if (!formats.empty()) column.format = formats.front();
  if (entry.isMember("exponent")) {
    if (!column.format || column.format->notation() != Notation::fixed) {
      file.fail(entry["exponent"], what + ": exponent needs decimals beside it");
    }
    constexpr int largest_exponent = 300;
    column.exponent =
        whole_field(file, entry, what, "exponent", -largest_exponent, largest_exponent);
  }
  return column;
}

ImportedCell cell_of(const JsonFile& file, const Json::Value& entry, const std::string& what) {
  ImportedCell cell{.at = fmt::format("{}: {}", file.at(entry), what)};
  if (entry.isNull()) return cell;
  if (entry.isString()) {
    cell.content = entry.asString();
  } else if (entry.isNumeric()) {
    cell.content = written_number(file.written(entry)).value();
  } else {
    file.require_fields(entry, what + ": a cell", {"value", "abs_error", "standard"});
    cell.content = number_field(file, entry, what, "value");
    const Uncertainty uncertainty = uncertainty_field(file, entry, what);
    cell.errors = {{"abs_error", uncertainty.bound}, {"standard", uncertainty.standard}};
  }
  return cell;
}

Table table_of(const std::string& name, const JsonFile& file, const Json::Value& entry,
               const std::string& what) {
  file.require_fields(entry, what, {"columns", "rows"});
  for (const char* field : {"columns", "rows"}) {
    if (!entry[field].isArray()) file.fail(entry, fmt::format("{} has no list of {}", what, field));
  }
  std::vector<ImportedColumn> columns;
  for (const Json::Value& column : entry["columns"]) {
    columns.push_back(
        column_of(file, column, fmt::format("{}, column {}", what, columns.size() + 1)));
  }
  std::vector<std::vector<ImportedCell>> rows;
  for (const Json::Value& row : entry["rows"]) {
    const std::string row_name = fmt::format("{}, row {}", what, rows.size() + 1);
    if (!row.isArray() || row.size() != columns.size()) {
      file.fail(row, fmt::format("{} must be a list of {} cells", row_name, columns.size()));
    }
    rows.emplace_back();
    for (const Json::Value& cell : row) rows.back().push_back(cell_of(file, cell, row_name));
  }
  return literate::table_of(name, columns, rows, fmt::format("{}: {}", file.at(entry), what));
}

/// Calls visit(name, entry) for each field of an object that need not be there.
template <typename Visit>
void for_each_field(const JsonFile& file, const std::string& field, Visit&& visit) {
  if (!file.root().isMember(field)) return;
  const Json::Value& entries = file.root()[field];
  if (!entries.isObject()) file.fail(entries, field + " must be an object");
  for (const std::string& name : entries.getMemberNames()) visit(name, entries[name]);
}

NumbersAndScript sources_of(const JsonFile& file, const fs::path& path, const fs::path& root) {
  const std::string what = "the file";
  const fs::path script = path.parent_path() / text_field(file, file.root(), what, "script");
  NumbersAndScript sources = with_script(path, file.text(), script, root);
  if (!file.root().isMember("script_sha256")) return sources;
  if (text_field(file, file.root(), what, "script_sha256") !=
      sys::sha256_of_text(sources.script.text)) {
    file.fail(file.root()["script_sha256"],
              fmt::format("'{}' has changed since it wrote these numbers: run it again",
                          sources.script.name));
  }
  return sources;
}

void require_new(const JsonFile& file, const Json::Value& entry, const std::string& what,
                 bool is_well_formed, const SourcePlace* known) {
  if (!is_well_formed)
    file.fail(entry, what +
                         ": a name must be letters, digits, '-' and '_', "
                         "and a key may hold '.' besides");
  if (known != nullptr) {
    file.fail(entry, fmt::format("{} is registered already, at {}", what, text_of(*known)));
  }
}

}  // namespace

void import_json(Document& document, const fs::path& file_path, const ImportOptions& options) {
  const JsonFile file(file_path);
  file.require_fields(file.root(), "the file", {"script", "script_sha256", "values", "tables"});
  const NumbersAndScript sources = sources_of(file, file_path, options.root);
  const auto place_of = [&](const Json::Value& entry) {
    return SourcePlace{sources.numbers.name, sources.script.name, file.line(entry)};
  };

  // Collect everything in a part of its own, so that an error leaves the document as it was.
  Document part;
  for_each_field(file, "values", [&](const std::string& name, const Json::Value& entry) {
    const std::string key = options.prefix + name;
    const std::string what = fmt::format("value '{}'", key);
    const bool is_known = document.values().contains(key);
    require_new(file, entry, what, is_key(key),
                is_known ? &document.registered().places.at({"value", key}) : nullptr);
    part.value(key, value_of(file, entry, what), place_of(entry));
  });
  for_each_field(file, "tables", [&](const std::string& name, const Json::Value& entry) {
    const std::string key = options.prefix + name;
    const std::string what = fmt::format("table '{}'", key);
    const bool is_known = document.tables().contains(key);
    require_new(file, entry, what, is_file_name(key),
                is_known ? &document.registered().places.at({"table", key}) : nullptr);
    part.table(table_of(key, file, entry, what), place_of(entry));
  });
  part.attach(sources.numbers);
  part.attach(sources.script);
  document.append(std::move(part));
}

}  // namespace literate
