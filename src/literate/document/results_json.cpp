// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/document/results_json.hpp"

#include <fmt/core.h>

#include <nlohmann/json.hpp>

namespace literate {
namespace {

using Json = nlohmann::ordered_json;

void add_known(Json& json, const std::optional<Number>& known) {
  if (!known) return;
  json["bound"] = known->bound;
  if (known->standard > 0) json["standard"] = known->standard;
}

void add_text(Json& json, const char* name, const std::string& text) {
  if (!text.empty()) json[name] = text;
}

Json json_of(const Value& value, const std::string& place) {
  Json json{{"printed", value.printed()}, {"latex", value.latex()}};
  if (value.is_text()) {
    json["text"] = value.printed();
  } else {
    json["number"] = value.number();
    add_known(json, value.known());
    if (value.is_as_is()) json["as_is"] = true;
    add_text(json, "unit", value.unit());
    json["format"] = value.format().text();
    json["earned"] = value.n_earned_digits();
  }
  json["place"] = place;
  return json;
}

Json json_of(const Column& column) {
  Json json{{"heading", column.heading()}};
  add_text(json, "group", column.group());
  if (column.numbers()) json["format"] = column.numbers()->text();
  add_text(json, "unit", column.unit());
  if (column.exponent() != 0) json["exponent"] = column.exponent();
  if (column.is_exact()) json["exact"] = true;
  if (column.width_cm() > 0) json["width_cm"] = column.width_cm();
  return json;
}

Json json_of(const Cell& cell, const std::string& printed) {
  if (cell.is_empty()) return nullptr;
  if (cell.number() == nullptr) return {{cell.is_latex() ? "latex" : "text", cell.given()}};
  Json json{{"number", *cell.number()}};
  add_known(json, cell.known());
  json["printed"] = printed;
  return json;
}

Json json_of(const Table& table, const std::string& place) {
  Json json{{"columns", Json::array()}, {"rows", Json::array()}};
  for (const Column& column : table.columns()) json["columns"].push_back(json_of(column));
  const auto printed = table.printed();
  for (std::size_t row = 0; row < printed.size(); ++row) {
    Json cells = Json::array();
    for (std::size_t i = 0; i < printed[row].size(); ++i) {
      cells.push_back(json_of(table.rows()[row][i], printed[row][i]));
    }
    json["rows"].push_back(std::move(cells));
  }
  json["notes"] = table.notes();
  json["place"] = place;
  return json;
}

Json json_of(const Figure& figure, const std::string& place) {
  Json data = Json::object();
  for (const auto& [block, columns] : figure.data) {
    data[block] = Json::array();
    for (const auto& [name, numbers] : columns.columns) data[block].push_back(name);
  }
  return {{"width_cm", figure.width_cm}, {"height_cm", figure.height_cm}, {"data", data},
          {"numbers", figure.numbers},   {"texts", figure.texts},         {"place", place}};
}

Json json_of(const std::vector<Criterion>& criteria) {
  Json json = Json::array();
  for (const Criterion& c : criteria) {
    Json one{{"name", c.name()},
             {"found", c.found().plain},
             {"limit", c.limit_phrase().plain},
             {"number", c.limit().number()},
             {"kind", name_of(c.limit().kind())},
             {"reason", c.limit().reason()},
             {"verdict", name_of(c.verdict())}};
    add_text(one, "missing", c.missing());
    if (c.margin().errors) one["margin_errors"] = *c.margin().errors;
    if (c.margin().factor) one["margin_factor"] = *c.margin().factor;
    json.push_back(std::move(one));
  }
  return json;
}

/// An object with one entry for each registered item.
template <typename Registered, typename Entry>
Json by_name(const Registered& registered, Entry&& entry) {
  Json json = Json::object();
  for (const auto& [name, one] : registered) json[name] = entry(name, one);
  return json;
}

/// One line for each entry, so that diff can compare two versions.
std::string laid_out(const Json& json) {
  std::string text;
  for (const auto& [key, value] : json.items()) {
    text += fmt::format("{}\n{}: ", text.empty() ? "{" : ",", Json(key).dump());
    if (!value.is_object() || value.empty()) {
      text += value.dump();
      continue;
    }
    const char* separator = "{";
    for (const auto& [name, entry] : value.items()) {
      text += fmt::format("{}\n  {}: {}", separator, Json(name).dump(), entry.dump());
      separator = ",";
    }
    text += "\n}";
  }
  return text + "\n}\n";
}

}  // namespace

std::string results_json(const Document& document, const std::string& case_name,
                         const std::vector<std::string>& files) {
  const auto with_place = [&](const char* kind) {
    return [&document, kind](const std::string& name, const auto& one) {
      return json_of(one, document.place_of(kind, name));
    };
  };
  Json json{{"schema", results_schema}, {"case", case_name}};
  json["values"] = by_name(document.values(), with_place("value"));
  json["flags"] = by_name(document.flags(), [&](const std::string& key, bool is_set) {
    return Json{{"value", is_set}, {"place", document.place_of("flag", key)}};
  });
  json["tables"] = by_name(document.tables(), with_place("table"));
  json["figures"] = by_name(document.figures(), with_place("figure"));
  json["checks"] = by_name(document.checks(), [&](const std::string& id, const Check& check) {
    return Json{{"statement", check.statement},
                {"passed", check.passed},
                {"criteria", json_of(check.criteria)},
                {"place", document.place_of("check", id)}};
  });
  int number = 0;
  json["claims"] = by_name(document.claims(), [&](const std::string& id, const Claim& claim) {
    return Json{{"number", ++number},
                {"verdict", name_of(claim.verdict())},
                {"expected", name_of(claim.expected)},
                {"route", claim.route},
                {"criteria", json_of(claim.criteria)},
                {"place", document.place_of("claim", id)}};
  });
  json["failed"] = document.faults();
  json["files"] = files;
  return laid_out(json);
}

}  // namespace literate
