// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/document/names.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>

#include "literate/document/ledger.hpp"
#include "literate/document/registered.hpp"
#include "literate/excerpts/excerpt.hpp"
#include "literate/text/latex.hpp"
#include "system/error.hpp"
#include "system/files.hpp"

namespace literate {
namespace {

using nlohmann::json;
using Places = Names::Places;

/// A standard uncertainty by its kinds; a bound of 0 beside it says nothing.
void add_uncertainty(json& entry, const std::optional<Uncertainty>& uncertainty) {
  if (!uncertainty) return;
  entry["abs_error"] = uncertainty->bound;
  if (uncertainty->sides) {
    entry["below"] = uncertainty->sides->first;
    entry["above"] = uncertainty->sides->second;
  }
  if (uncertainty->neglected > 0) entry["neglected"] = uncertainty->neglected;
  if (uncertainty->standard == 0) return;
  entry["standard"] = uncertainty->standard;
  entry["kinds"] = uncertainty->kinds;
}

json value_json(const Value& value, const SourcePlace& place) {
  json entry{{"printed", value.printed()}, {"place", text_of(place)}};
  if (value.number()) entry["number"] = *value.number();
  add_uncertainty(entry, value.uncertainty());
  if (!value.unit().empty()) entry["unit"] = value.unit();
  if (!value.format()) return entry;
  const Format& format = *value.format();
  entry["notation"] = name_of(format.notation());
  entry["digits"] = format.digits();
  entry["last_place"] = value.last_place();
  const bool is_exact = format.notation() == Notation::exact ||
                        format.notation() == Notation::integer ||
                        (value.uncertainty() && value.uncertainty()->error() == 0);
  if (is_exact) entry["exact"] = true;
  if (format.is_percentage()) entry["percent"] = true;
  if (format.rounds_up()) entry["rounded_up"] = true;
  if (format.tells_kinds()) entry["by_kind"] = true;
  return entry;
}

std::optional<StoredNumber> stored_number(const json& entry) {
  if (!entry.contains("number")) return std::nullopt;
  StoredNumber stored;
  stored.number = entry.at("number").get<double>();
  if (entry.contains("abs_error")) {
    stored.uncertainty = Uncertainty(entry.at("abs_error").get<double>());
    if (entry.contains("below")) {
      stored.uncertainty->sides = {entry.at("below").get<double>(),
                                   entry.at("above").get<double>()};
    }
    stored.uncertainty->standard = entry.value("standard", 0.0);
    stored.uncertainty->kinds = entry.value("kinds", std::map<std::string, double>());
    stored.uncertainty->neglected = entry.value("neglected", 0.0);
  }
  stored.unit = entry.value("unit", "");
  stored.notation = notation_of(entry.at("notation").get<std::string>());
  stored.digits = entry.at("digits").get<int>();
  stored.last_place = entry.at("last_place").get<int>();
  stored.is_exact = entry.value("exact", false);
  stored.is_percentage = entry.value("percent", false);
  stored.rounds_up = entry.value("rounded_up", false);
  stored.tells_kinds = entry.value("by_kind", false);
  return stored;
}

std::map<std::string, StoredNumber> numbers_in(const json& values) {
  std::map<std::string, StoredNumber> numbers;
  for (const auto& entry : values.items()) {
    if (const auto stored = stored_number(entry.value())) numbers.emplace(entry.key(), *stored);
  }
  return numbers;
}

/// What stands in the cells of tables, by table, row and column: numbers, and texts as LaTeX.
json cells_json(const std::map<std::string, Table>& tables) {
  json entries = json::object();
  for (const auto& [name, table] : tables) {
    const auto key = [&](std::size_t row, std::size_t column) {
      return fmt::format("table {}, row {}, column {}", name, row + 1, column + 1);
    };
    for (const auto& [place, printed] : table.printed_numbers()) {
      const Cell& cell = table.rows()[place.first][place.second];
      json& entry = entries[key(place.first, place.second)];
      entry = {{"number", *cell.number()}, {"printed", printed}};
      add_uncertainty(entry, cell.uncertainty());
      const std::string& unit = table.columns()[place.second].format().unit;
      if (!unit.empty()) entry["unit"] = unit;
    }
    for (std::size_t i = 0; i < table.rows().size(); ++i) {
      for (std::size_t j = 0; j < table.rows()[i].size(); ++j) {
        const std::string* text = table.rows()[i][j].text();
        if (text != nullptr && !text->empty()) entries[key(i, j)] = {{"printed", *text}};
      }
    }
  }
  return entries;
}

json checks_json(const std::vector<Check>& checks) {
  json entries = json::object();
  for (const Check& check : checks) {
    entries[check.id] = {{"passed", check.passed}, {"statement", check.statement}};
  }
  return entries;
}

json criteria_json(const std::vector<Criterion>& criteria) {
  json entries = json::array();
  for (const Criterion& criterion : criteria) {
    json entry{{"name", criterion.name()},
               {"found", criterion.found().plain},
               {"limit", criterion.limit().plain},
               {"reason", criterion.reason()},
               {"margin", criterion.margin().text()},
               {"outcome", name_of(criterion.outcome())}};
    if (!criterion.missing().empty()) entry["missing"] = criterion.missing();
    entries.push_back(entry);
  }
  return entries;
}

json claims_json(const Registered& registered) {
  json entries = json::object();
  for (const auto& [id, claim] : registered.claims) {
    const SourcePlace& place = registered.places.at({"claim", id});
    entries[id] = {{"place", fmt::format("{}:{}", text_of(place), place.column)},
                   {"route", claim.route},
                   {"criteria", criteria_json(claim.criteria)},
                   {"severity", severity_text(registered, id)},
                   {"expected", name_of(claim.expected)},
                   {"found", name_of(claim.found())}};
  }
  return entries;
}

json excerpts_json(const std::vector<Excerpt>& excerpts) {
  json entries = json::object();
  for (const Excerpt& excerpt : excerpts) {
    entries[excerpt.name] = {{"file", excerpt.file},
                             {"language", listing_language(excerpt.file)},
                             {"first_line", excerpt.first_line},
                             {"last_line", last_line(excerpt)}};
  }
  return entries;
}

/// Where each of a kind was registered, «file:line» by its name.
json places_json(const Registered& registered, std::string_view kind) {
  json places = json::object();
  for (const auto& [name, place] : registered.places) {
    if (name.first == kind) places[name.second] = text_of(place);
  }
  return places;
}

std::set<std::string> keys_of(const json& entries) {
  std::set<std::string> keys;
  for (const auto& entry : entries.items()) keys.insert(entry.key());
  return keys;
}

Places places_in(const json& entries) {
  Places places;
  for (const auto& entry : entries.items()) places[entry.key()] = entry.value().at("place");
  return places;
}

std::map<std::string, NamedClaim> claims_in(const json& entries) {
  std::map<std::string, NamedClaim> claims;
  for (const auto& entry : entries.items()) {
    const json& claim = entry.value();
    claims[entry.key()] = {
        .place = claim.at("place"), .expected = claim.at("expected"), .found = claim.at("found")};
    for (const json& criterion : claim.at("criteria")) {
      claims[entry.key()].limits.push_back({.quantity = criterion.at("name"),
                                            .condition = criterion.at("limit"),
                                            .reason = criterion.at("reason")});
    }
  }
  return claims;
}

/// What the program says in words: routes, criteria and reasons, headings of tables, checks.
json texts_json(const Registered& registered) {
  json texts = json::array();
  const auto add = [&](const char* kind, const std::string& name, const char* part,
                       const std::string& latex) {
    texts.push_back({{"what", fmt::format("{} of {} '{}'", part, kind, name)},
                     {"place", text_of(registered.places.at({kind, name}))},
                     {"latex", latex}});
  };
  const auto add_criteria = [&](const char* kind, const std::string& name,
                                const std::vector<Criterion>& criteria) {
    for (const Criterion& criterion : criteria) {
      add(kind, name, "quantity", escape_latex(criterion.name()));
      // The numbers of a formula are evaluated, and so not typed.
      const std::string& reason = criterion.limit_reason();
      const bool has_formula = criterion.limit_kind() == LimitKind::theory;
      add(kind, name, "reason",
          escape_latex(reason.substr(has_formula ? reason.find(", ") + 2 : 0)));
    }
  };
  for (const auto& [id, claim] : registered.claims) {
    add("claim", id, "route", escape_latex(claim.route));
    add_criteria("claim", id, claim.criteria);
  }
  for (const Check& check : registered.checks) {
    add("check", check.id, "statement", escape_latex(check.statement));
  }
  for (const auto& [name, table] : registered.tables) {
    for (const Column& column : table.columns())
      add("table", name, "heading", column.format().heading);
    for (const TableNote& note : table.notes()) add("table", name, "note", note.text);
  }
  return texts;
}

/// The same, as Manifest::words names them.
json words_json(const Registered& registered) {
  json words = json::object();
  for (const auto& [id, claim] : registered.claims) {
    words[fmt::format("claim {}: route", id)] = claim.route;
    words[fmt::format("claim {}: planted faults", id)] = severity_text(registered, id);
    for (const Criterion& criterion : claim.criteria) {
      words[fmt::format("claim {}: {}: reason", id, criterion.name())] = criterion.reason();
      words[fmt::format("claim {}: {}: margin", id, criterion.name())] = criterion.margin().text();
    }
  }
  for (const auto& [key, value] : registered.values) {
    if (!value.uncertainty() || value.uncertainty()->kinds.size() < 2) continue;
    std::vector<std::string> kinds;
    for (const auto& [kind, u] : value.uncertainty()->kinds) {
      kinds.push_back(fmt::format("{} {:.2g}", kind, u));
    }
    words[fmt::format("value {}: sources of uncertainty", key)] =
        fmt::format("{}", fmt::join(kinds, ", "));
  }
  for (const Check& check : registered.checks) {
    words[fmt::format("check {}: statement", check.id)] = check.statement;
  }
  for (const auto& [name, table] : registered.tables) {
    std::vector<std::string> headings, notes;
    for (const Column& column : table.columns()) {
      headings.push_back(csv_heading(column.format()));
    }
    for (const TableNote& note : table.notes()) notes.push_back(note.mark + plain_text(note.text));
    words[fmt::format("table {}: headings", name)] = fmt::format("{}", fmt::join(headings, " | "));
    words[fmt::format("table {}: notes", name)] = fmt::format("{}", fmt::join(notes, " | "));
  }
  return words;
}

std::vector<NamedText> texts_in(const json& entries) {
  std::vector<NamedText> texts;
  for (const json& entry : entries) {
    texts.push_back(
        {.what = entry.at("what"), .place = entry.at("place"), .latex = entry.at("latex")});
  }
  return texts;
}

}  // namespace

std::string names_json(const Registered& registered, const std::vector<Excerpt>& excerpts,
                       const std::vector<std::string>& files) {
  json names;
  names["values"] = json::object();
  for (const auto& [key, value] : registered.values) {
    names["values"][key] = value_json(value, registered.places.at({"value", key}));
  }
  names["flags"] = registered.flags;
  names["cells"] = cells_json(registered.tables);
  names["tables"] = json::array();
  names["long_tables"] = json::array();
  for (const auto& [name, table] : registered.tables) {
    names["tables"].push_back(name);
    if (table.breaks_over_pages()) names["long_tables"].push_back(name);
  }
  names["places"] = {{"flags", places_json(registered, "flag")},
                     {"tables", places_json(registered, "table")}};
  names["figures"] = json::object();
  for (const auto& [name, place] : figure_places(registered)) {
    names["figures"][name] = {{"place", place}};
  }
  names["excerpts"] = excerpts_json(excerpts);
  names["checks"] = checks_json(registered.checks);
  names["claims"] = claims_json(registered);
  names["imports"] = registered.attachments.digests();
  names["texts"] = texts_json(registered);
  names["words"] = words_json(registered);
  names["faults"] = faults(registered);
  names["claim_notes"] = claim_notes(registered);
  names["files"] = files;
  if (!registered.case_name.empty()) names["case_name"] = registered.case_name;
  if (!registered.case_sha256.empty()) names["case_sha256"] = registered.case_sha256;
  return names.dump(2) + "\n";
}

Names read_names(const std::filesystem::path& file) {
  try {
    const json names = json::parse(sys::read_file(file));
    return {.values = places_in(names.at("values")),
            .tables = names.at("places").at("tables").get<Places>(),
            .figures = places_in(names.at("figures")),
            .numbers = numbers_in(names.at("values")),
            .flags = names.at("flags").get<std::map<std::string, bool>>(),
            .flag_places = names.at("places").at("flags").get<Places>(),
            .excerpts = keys_of(names.at("excerpts")),
            .claims = claims_in(names.at("claims")),
            .texts = texts_in(names.at("texts")),
            .faults = names.at("faults").get<std::vector<std::string>>(),
            .claim_notes = names.value("claim_notes", std::vector<std::string>{}),
            .files = names.at("files").get<std::vector<std::string>>(),
            .case_sha256 = names.value("case_sha256", "")};
  } catch (const std::exception& error) {
    throw sys::OutputError(
        fmt::format("'{}' is not a list of names: {}", file.string(), error.what()));
  }
}

std::vector<std::string> former_files(const std::filesystem::path& file) {
  if (!std::filesystem::is_regular_file(file)) return {};
  try {
    return json::parse(sys::read_file(file)).at("files").get<std::vector<std::string>>();
  } catch (const json::exception&) {
    return {};
  }
}

}  // namespace literate
