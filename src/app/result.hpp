// SPDX-License-Identifier: GPL-3.0-or-later
// What a command has found, said once. CSV, JSON, text and picture follow from it.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "literate/figures/figure.hpp"

namespace app {

/// A column of a table: numbers, or texts.
struct Column {
  std::string key;                      ///< in CSV and JSON; empty if only people see it
  std::vector<std::string> heads = {};  ///< above it for people; none if only programs see it
  int width = 0;                        ///< for people, with blanks before it; < 0 to the left
  std::string format = "{}";            ///< of its numbers for people
  std::vector<double> numbers = {};     ///< as many in each column
  std::vector<std::string> texts = {};  ///< or these
  bool is_absent = false;               ///< people see dashes, programs nothing
  bool may_be_infinite = false;         ///< CSV says inf; JSON, which cannot, leaves it out
};

/// A column with a number of each row.
template <class Rows, class OfRow>
Column column_of(const Rows& rows, std::string key, std::vector<std::string> heads, int width,
                 std::string format, const OfRow& of_row) {
  Column column{std::move(key), std::move(heads), width, std::move(format)};
  for (const auto& row : rows) column.numbers.push_back(of_row(row));
  return column;
}

enum class InJson {
  no,
  rows,     ///< an array of objects; alone in a result, it is all of the JSON
  columns,  ///< an array for each column
  by_text   ///< an object for each row, under the text of the first column
};

struct Table {
  std::vector<Column> columns;
  InJson in_json = InJson::rows;
  std::string name = {};  ///< in JSON, unless it stands in columns
};

/// One number of a result, with that of the closed form beside it, if there is one.
struct Quantity {
  std::string key;    ///< in JSON, where numbers of one key are an array; empty for people only
  std::string label;  ///< for people
  double value;
  std::string unit;
  std::optional<double> exact = {};  ///< may be infinite
};

struct Result {
  std::vector<Quantity> quantities = {};
  std::string closed_form = {};         ///< in JSON the name of the numbers of the closed form
  nlohmann::ordered_json details = {};  ///< what else JSON says
  std::vector<Table> tables = {};       ///< the first is the CSV
  std::string notes = {};               ///< what else people read, below the tables
  std::vector<std::string> warnings = {};
  std::string script = {};                        ///< of the picture
  std::function<literate::Figure()> figure = {};  ///< empty if there is nothing to draw
};

/// Throws sys::InputError naming a number of the result that is not finite.
void require_finite(const Result& result);

/// A header and a row a line, numbers with the shortest digits that round-trip.
std::string csv_text(const Table& table);

/// Quantities, details, closed form and tables under their names, indented.
std::string json_of(const Result& result);

/// A JSON value with the shortest digits that round-trip for every number. (nlohmann's own dump()
/// uses Grisu2, which misses the shortest about once in a thousand.) Throws sys::InputError for a
/// number that is not finite, which JSON cannot say.
std::string json_text(const nlohmann::ordered_json& value);

/// Quantities beside their closed forms, aligned tables, and notes.
std::string text_for_people(const Result& result);

}  // namespace app
