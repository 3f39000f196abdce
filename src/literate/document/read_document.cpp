// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/document/read_document.hpp"

#include <fmt/core.h>

#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "literate/document/results_json.hpp"
#include "system/files.hpp"
#include "system/text.hpp"

namespace literate {
namespace {

// A missing key or a wrong type is an exception of this library, which names the path to it:
// «(/values/x/bound) type must be number, but is string». JSON_DIAGNOSTICS adds the path.
using Json = nlohmann::ordered_json;

void require_keys(const Json& json, const std::set<std::string>& allowed) {
  if (!json.is_object()) {
    throw std::invalid_argument(fmt::format("{} must be an object", json.dump().substr(0, 40)));
  }
  for (const auto& [key, value] : json.items()) {
    if (allowed.contains(key)) continue;
    throw std::invalid_argument(
        fmt::format("unknown key '{}'{}", key, sys::suggestion(key, allowed)));
  }
}

std::string text_of(const Json& json) {
  return json.get<std::string>();
}

int integer_of(const Json& json) {
  if (json.is_number_integer()) return json.get<int>();
  throw std::invalid_argument(fmt::format("{} must be a whole number", json.dump()));
}

/// The number with its errors; none if the script gives neither a bound nor a standard uncertainty.
std::optional<Number> known_of(const Json& json) {
  if (!json.contains("bound") && !json.contains("standard")) return std::nullopt;
  return Number(json.at("number").get<double>(), json.value("bound", 0.0),
                json.value("standard", 0.0));
}

Value value_of(const Json& json) {
  if (json.contains("text")) {
    require_keys(json, {"text", "place"});
    return Value::text(text_of(json.at("text")));
  }
  require_keys(json, {"number", "bound", "standard", "as_is", "format", "unit", "place"});
  const auto number = json.at("number").get<double>();
  const Format format = Format::parse(text_of(json.at("format")));
  const std::string unit = json.value("unit", "");
  if (const auto known = known_of(json)) return {*known, format, unit};
  const Value bare(number, format, unit);
  return json.value("as_is", false) ? bare.as_is() : bare;
}

Column column_of(const Json& json, const Place& place) {
  require_keys(json, {"heading", "group", "format", "unit", "exponent", "exact", "width_cm"});
  const std::string heading = text_of(json.at("heading"));
  Column column = json.contains("format")
                      ? Column(heading, Format::parse(text_of(json.at("format"))),
                               json.value("unit", ""), place)
                      : Column::text(heading, json.value("width_cm", 0.0), place);
  if (json.contains("exponent")) column = column.scaled(integer_of(json.at("exponent")), place);
  if (json.value("exact", false)) column = column.exact();
  return json.contains("group") ? column.under(text_of(json.at("group")), place) : column;
}

Cell cell_of(const Json& json) {
  if (json.is_null()) return {};
  if (json.is_string()) return text_of(json);
  if (json.is_number_integer()) return Number(json.get<double>(), 0);
  if (json.is_number()) return json.get<double>();
  if (json.contains("latex")) {
    require_keys(json, {"latex"});
    return Cell::latex(text_of(json.at("latex")));
  }
  require_keys(json, {"number", "bound", "standard", "quoted"});
  const auto number = json.at("number").get<double>();
  if (json.contains("quoted")) return Cell::quoted(number, integer_of(json.at("quoted")));
  const auto known = known_of(json);
  return known ? Cell(*known) : Cell(number);
}

Table table_of(const std::string& name, const Json& json, const Place& place) {
  require_keys(json, {"columns", "rows", "notes", "place"});
  std::vector<Column> columns;
  for (const Json& column : json.at("columns")) columns.push_back(column_of(column, place));
  Table table(name, columns, place);
  for (const Json& row : json.at("rows")) {
    std::vector<Cell> cells;
    for (const Json& cell : row) cells.push_back(cell_of(cell));
    table.add_row(std::move(cells), place);
  }
  if (json.contains("notes")) {
    for (const Json& note : json.at("notes")) table.note(text_of(note), place);
  }
  return table;
}

FigureData data_of(const Json& json) {
  require_keys(json, {"columns", "row_length"});
  FigureData data;
  data.row_length = json.value("row_length", data.row_length);
  for (const auto& [name, column] : json.at("columns").items()) {
    std::vector<double> numbers;
    for (const Json& number : column) {
      numbers.push_back(number.is_null() ? gap : number.get<double>());
    }
    data.columns.emplace_back(name, std::move(numbers));
  }
  return data;
}

Figure figure_of(const Json& json) {
  require_keys(json, {"width_cm", "height_cm", "data", "numbers", "texts", "place"});
  Figure figure{.width_cm = json.at("width_cm").get<double>(),
                .height_cm = json.at("height_cm").get<double>()};
  if (json.contains("data")) {
    for (const auto& [name, one] : json.at("data").items()) figure.data[name] = data_of(one);
  }
  figure.numbers = json.value("numbers", figure.numbers);
  figure.texts = json.value("texts", figure.texts);
  return figure;
}

Limit limit_of(const Json& json) {
  require_keys(json, {"number", "kind", "reason", "counting"});
  const Limit limit(json.at("number").get<double>(), limit_kind_named(text_of(json.at("kind"))),
                    text_of(json.at("reason")));
  return json.contains("counting") ? limit.counting(json.at("counting").get<double>()) : limit;
}

std::vector<Criterion> criteria_of(const Json& json, const Place& place);

Criterion criterion_of(const Json& json, const Place& place) {
  const std::string test = text_of(json.at("test"));
  const std::string name = text_of(json.at("name"));
  if (test == "in_each") {
    require_keys(json, {"name", "test", "cases", "each"});
    return Criterion::in_each(name, text_of(json.at("cases")), criteria_of(json.at("each"), place),
                              place);
  }
  if (test == "at_most" || test == "at_least") {
    require_keys(json, {"name", "test", "quantity", "limit"});
    const Value quantity = value_of(json.at("quantity"));
    const Limit limit = limit_of(json.at("limit"));
    return test == "at_most" ? Criterion::at_most(name, quantity, limit, place)
                             : Criterion::at_least(name, quantity, limit, place);
  }
  if (test == "agrees" || test == "agrees_relatively") {
    require_keys(json, {"name", "test", "quantity", "stated", "limit"});
    const Value quantity = value_of(json.at("quantity")), stated = value_of(json.at("stated"));
    const Limit limit = limit_of(json.at("limit"));
    return test == "agrees" ? Criterion::agrees(name, quantity, stated, limit, place)
                            : Criterion::agrees_relatively(name, quantity, stated, limit, place);
  }
  throw std::invalid_argument(fmt::format(
      "'{}' is not a test: at_most, at_least, agrees, agrees_relatively or in_each", test));
}

std::vector<Criterion> criteria_of(const Json& json, const Place& place) {
  std::vector<Criterion> criteria;
  for (const Json& one : json) criteria.push_back(criterion_of(one, place));
  return criteria;
}

void read_check(Document& document, const std::string& id, const Json& json, const Place& place) {
  require_keys(json, {"statement", "passed", "criteria", "place"});
  const std::string statement = text_of(json.at("statement"));
  if (json.contains("criteria")) {
    document.check(id, criteria_of(json.at("criteria"), place), statement, place);
  } else {
    document.check(id, json.at("passed").get<bool>(), statement, place);
  }
}

void read_claim(Document& document, const std::string& id, const Json& json, const Place& place) {
  require_keys(json, {"route", "expected", "criteria", "place"});
  document.claim(id,
                 {.route = text_of(json.at("route")),
                  .expected = verdict_named(text_of(json.at("expected"))),
                  .criteria = criteria_of(json.at("criteria"), place)},
                 place);
}

void read_entry(Document& document, const std::string& kind, const std::string& name,
                const Json& json, const Place& place) {
  if (kind == "values") {
    document.value(name, value_of(json), place);
  } else if (kind == "flags") {
    require_keys(json, {"value", "place"});
    document.flag(name, json.at("value").get<bool>(), place);
  } else if (kind == "tables") {
    document.table(table_of(name, json, place), place);
  } else if (kind == "figures") {
    document.figure(name, figure_of(json), place);
  } else if (kind == "checks") {
    read_check(document, name, json, place);
  } else if (kind == "claims") {
    read_claim(document, name, json, place);
  }
}

/// Parses a text. Throws std::invalid_argument for a key that an object has twice.
Json parsed_once(const std::string& text) {
  std::vector<std::set<std::string>> keys;  // of the open objects
  return Json::parse(text, [&](int, Json::parse_event_t event, Json& parsed) {
    if (event == Json::parse_event_t::object_start) keys.emplace_back();
    if (event == Json::parse_event_t::object_end) keys.pop_back();
    if (event == Json::parse_event_t::key && !keys.back().insert(text_of(parsed)).second) {
      throw std::invalid_argument(fmt::format("the key '{}' is given twice", text_of(parsed)));
    }
    return true;
  });
}

}  // namespace

Document read_document(const std::filesystem::path& file) {
  const std::string text = sys::read_file(file);
  const std::string name = file.generic_string();
  std::string within;  // the entry, such as «values.x: »
  try {
    const Json json = parsed_once(text);
    require_keys(json, {"schema", "values", "flags", "tables", "figures", "checks", "claims"});
    if (const int schema = integer_of(json.at("schema")); schema != results_schema) {
      throw std::invalid_argument(
          fmt::format("schema {}, and this program reads schema {}", schema, results_schema));
    }
    Document document;
    for (const auto& [kind, entries] : json.items()) {
      if (kind == "schema") continue;
      if (!entries.is_object()) throw std::invalid_argument(kind + " must be an object");
      for (const auto& [key, one] : entries.items()) {
        within = fmt::format("{}.{}: ", kind, key);
        read_entry(document, kind, key, one, Place(one.value("place", file.filename().string())));
      }
    }
    return document;
  } catch (const std::invalid_argument& error) {
    throw Error(fmt::format("{}: {}{}", name, within, error.what()));
  } catch (const Json::exception& error) {
    // «[json.exception.parse_error.101] parse error at line 3, column 5: …»
    const std::string_view what = error.what();
    throw Error(fmt::format("{}: {}", name, what.substr(what.find("] ") + 2)));
  }
}

}  // namespace literate
