// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/results/read_document.hpp"

#include <fmt/core.h>

#include <string>
#include <utility>
#include <vector>

#include "literate/document/results_json.hpp"
#include "literate/results/strict_json.hpp"

namespace literate {
namespace {

Place place_of(const StrictJson& json) {
  const auto place = json.find("place");
  return Place(place ? place->text() : std::filesystem::path(json.file()).filename().string());
}

Format format_of(const StrictJson& json) {
  return json.at_this([&] { return Format::parse(json.text()); });
}

std::string text_or_nothing(const StrictJson& json, const std::string& key) {
  const auto text = json.find(key);
  return text ? text->text() : "";
}

/// The number with its errors; none if the script gives neither a bound nor a standard uncertainty.
std::optional<Number> known_of(const StrictJson& json) {
  const auto bound = json.find("bound"), standard = json.find("standard");
  if (!bound && !standard) return std::nullopt;
  return Number(json["number"].number(), bound ? bound->number() : 0,
                standard ? standard->number() : 0);
}

Value value_of(const StrictJson& json) {
  if (json.has("text")) {
    json.require_keys({"text", "place"});
    return Value::text(json["text"].text());
  }
  json.require_keys({"number", "bound", "standard", "as_is", "format", "unit", "place"});
  const double number = json["number"].number();
  const Format format = format_of(json["format"]);
  const std::string unit = text_or_nothing(json, "unit");
  if (const auto known = known_of(json)) return {*known, format, unit};
  const Value bare(number, format, unit);
  const auto as_is = json.find("as_is");
  return as_is && as_is->boolean() ? bare.as_is() : bare;
}

Column column_of(const StrictJson& json, const Place& place) {
  json.require_keys({"heading", "group", "format", "unit", "exponent", "exact", "width_cm"});
  const std::string heading = json["heading"].text();
  const auto format = json.find("format"), width = json.find("width_cm");
  Column column = format ? Column(heading, format_of(*format), text_or_nothing(json, "unit"), place)
                         : Column::text(heading, width ? width->number() : 0, place);
  if (const auto exponent = json.find("exponent")) {
    column = column.scaled(exponent->integer(), place);
  }
  if (const auto exact = json.find("exact"); exact && exact->boolean()) column = column.exact();
  const std::string group = text_or_nothing(json, "group");
  return group.empty() ? column : column.under(group, place);
}

Cell cell_of(const StrictJson& json) {
  if (json.is_null()) return {};
  if (json.is_text()) return json.text();
  if (json.is_integer()) return Number(json.number(), 0);
  if (json.is_number()) return json.number();
  if (json.has("latex")) {
    json.require_keys({"latex"});
    return Cell::latex(json["latex"].text());
  }
  json.require_keys({"number", "bound", "standard", "quoted"});
  const double number = json["number"].number();
  if (const auto quoted = json.find("quoted")) return Cell::quoted(number, quoted->integer());
  const auto known = known_of(json);
  return known ? Cell(*known) : Cell(number);
}

Table table_of(const std::string& name, const StrictJson& json) {
  json.require_keys({"columns", "rows", "notes", "place"});
  const Place place = place_of(json);
  std::vector<Column> columns;
  for (const StrictJson& column : json["columns"].elements()) {
    columns.push_back(column_of(column, place));
  }
  Table table(name, columns, place);
  for (const StrictJson& row : json["rows"].elements()) {
    std::vector<Cell> cells;
    for (const StrictJson& cell : row.elements()) cells.push_back(cell_of(cell));
    table.add_row(std::move(cells), place);
  }
  if (const auto notes = json.find("notes")) {
    for (const StrictJson& note : notes->elements()) table.note(note.text(), place);
  }
  return table;
}

FigureData data_of(const StrictJson& json) {
  json.require_keys({"columns", "row_length"});
  FigureData data;
  for (const auto& [name, column] : json["columns"].entries()) {
    std::vector<double> numbers;
    for (const StrictJson& number : column.elements()) {
      numbers.push_back(number.is_null() ? gap : number.number());
    }
    data.columns.emplace_back(name, std::move(numbers));
  }
  if (const auto length = json.find("row_length")) {
    if (length->integer() < 0) length->fail("must not be below zero");
    data.row_length = static_cast<std::size_t>(length->integer());
  }
  return data;
}

Figure figure_of(const StrictJson& json) {
  json.require_keys({"width_cm", "height_cm", "data", "numbers", "texts", "place"});
  Figure figure{.width_cm = json["width_cm"].number(), .height_cm = json["height_cm"].number()};
  const auto each = [&json](const std::string& key, auto&& read) {
    const auto all = json.find(key);
    if (!all) return;
    for (const auto& [name, one] : all->entries()) read(name, one);
  };
  each("data", [&](const auto& name, const auto& one) { figure.data[name] = data_of(one); });
  each("numbers", [&](const auto& name, const auto& one) { figure.numbers[name] = one.number(); });
  each("texts", [&](const auto& name, const auto& one) { figure.texts[name] = one.text(); });
  return figure;
}

LimitKind kind_of(const StrictJson& json) {
  const std::string name = json.text();
  for (const LimitKind kind :
       {LimitKind::theory, LimitKind::data, LimitKind::method, LimitKind::choice}) {
    if (name == name_of(kind)) return kind;
  }
  json.fail(fmt::format("'{}' is not a kind of limit: theory, data, method or choice", name));
}

Limit limit_of(const StrictJson& json) {
  json.require_keys({"number", "bound", "kind", "reason", "counting", "digits"});
  const auto bound = json.find("bound"), digits = json.find("digits");
  const Limit limit({json["number"].number(), bound ? bound->number() : 0}, kind_of(json["kind"]),
                    json["reason"].text(), digits ? digits->integer() : 0);
  const auto counting = json.find("counting");
  return counting ? limit.counting(counting->number()) : limit;
}

std::vector<Criterion> criteria_of(const StrictJson& json, const Place& place);

Criterion criterion_of(const StrictJson& json, const Place& place) {
  const std::string test = json["test"].text();
  const std::string name = json["name"].text();
  if (test == "in_each") {
    json.require_keys({"name", "test", "cases", "each"});
    return Criterion::in_each(name, json["cases"].text(), criteria_of(json["each"], place), place);
  }
  if (test == "at_most" || test == "at_least") {
    json.require_keys({"name", "test", "quantity", "limit"});
    const Value quantity = value_of(json["quantity"]);
    const Limit limit = limit_of(json["limit"]);
    return test == "at_most" ? Criterion::at_most(name, quantity, limit, place)
                             : Criterion::at_least(name, quantity, limit, place);
  }
  if (test == "agrees" || test == "agrees_relatively") {
    json.require_keys({"name", "test", "quantity", "stated", "limit"});
    const Value quantity = value_of(json["quantity"]), stated = value_of(json["stated"]);
    const Limit limit = limit_of(json["limit"]);
    return test == "agrees" ? Criterion::agrees(name, quantity, stated, limit, place)
                            : Criterion::agrees_relatively(name, quantity, stated, limit, place);
  }
  json["test"].fail(fmt::format(
      "'{}' is not a test: at_most, at_least, agrees, agrees_relatively or in_each", test));
}

std::vector<Criterion> criteria_of(const StrictJson& json, const Place& place) {
  std::vector<Criterion> criteria;
  for (const StrictJson& one : json.elements()) criteria.push_back(criterion_of(one, place));
  return criteria;
}

void read_check(Document& document, const std::string& id, const StrictJson& json) {
  json.require_keys({"statement", "passed", "criteria", "place"});
  const Place place = place_of(json);
  if (const auto criteria = json.find("criteria")) {
    document.check(id, criteria_of(*criteria, place), json["statement"].text(), place);
  } else {
    document.check(id, json["passed"].boolean(), json["statement"].text(), place);
  }
}

void read_claim(Document& document, const std::string& id, const StrictJson& json) {
  json.require_keys({"route", "expected", "criteria", "place"});
  const Place place = place_of(json);
  const StrictJson expected = json["expected"];
  document.claim(id,
                 {.route = json["route"].text(),
                  .expected = expected.at_this([&] { return verdict_named(expected.text()); }),
                  .criteria = criteria_of(json["criteria"], place)},
                 place);
}

}  // namespace

Document read_document(const std::filesystem::path& file) {
  const StrictJson json = StrictJson::parse_file(file);
  json.require_keys({"schema", "values", "flags", "tables", "figures", "checks", "claims"});
  if (const int schema = json["schema"].integer(); schema != results_schema) {
    json["schema"].fail(
        fmt::format("schema {}, and this program reads schema {}", schema, results_schema));
  }
  Document document;
  const auto each = [&json](const std::string& key, auto&& read) {
    const auto all = json.find(key);
    if (!all) return;
    for (const auto& [name, one] : all->entries()) read(name, one);
  };
  each("values", [&](const std::string& key, const StrictJson& one) {
    document.value(key, value_of(one), place_of(one));
  });
  each("flags", [&](const std::string& key, const StrictJson& one) {
    one.require_keys({"value", "place"});
    document.flag(key, one["value"].boolean(), place_of(one));
  });
  each("tables", [&](const std::string& name, const StrictJson& one) {
    document.table(table_of(name, one), place_of(one));
  });
  each("figures", [&](const std::string& name, const StrictJson& one) {
    document.figure(name, figure_of(one), place_of(one));
  });
  each("checks",
       [&](const std::string& id, const StrictJson& one) { read_check(document, id, one); });
  each("claims",
       [&](const std::string& id, const StrictJson& one) { read_claim(document, id, one); });
  return document;
}

}  // namespace literate
