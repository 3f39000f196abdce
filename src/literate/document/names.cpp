// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/document/names.hpp"

#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "literate/document/registered.hpp"
#include "system/error.hpp"
#include "system/files.hpp"

namespace literate {
namespace {

using nlohmann::json;

json value_json(const Value& value, const SourcePlace& place) {
  json entry{{"printed", value.printed()}, {"place", text_of(place)}};
  if (value.number()) entry["number"] = *value.number();
  if (value.abs_error()) entry["abs_error"] = *value.abs_error();
  if (!value.unit().empty()) entry["unit"] = value.unit();
  return entry;
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
               {"condition", criterion.condition().plain},
               {"reason", criterion.reason()},
               {"outcome", name_of(criterion.outcome())}};
    if (!criterion.missing().empty()) entry["missing"] = criterion.missing();
    entries.push_back(entry);
  }
  return entries;
}

json claims_json(const Registered& registered) {
  json entries = json::object();
  for (const auto& [id, claim] : registered.claims) {
    entries[id] = {{"sentence", claim.sentence},
                   {"place", claim.place},
                   {"route", claim.route},
                   {"criteria", criteria_json(claim.criteria)},
                   {"expected", name_of(claim.expected)},
                   {"found", name_of(claim.found())}};
  }
  return entries;
}

json excerpts_json(const std::vector<Excerpt>& excerpts) {
  json entries = json::object();
  for (const Excerpt& excerpt : excerpts) {
    entries[excerpt.name] = {{"file", excerpt.file},
                             {"first_line", excerpt.first_line},
                             {"last_line", last_line(excerpt)}};
  }
  return entries;
}

template <typename Map>
json keys_json(const Map& map) {
  json keys = json::array();
  for (const auto& entry : map) keys.push_back(entry.first);
  return keys;
}

std::set<std::string> keys_of(const json& entries) {
  std::set<std::string> keys;
  for (const auto& entry : entries.items()) keys.insert(entry.key());
  return keys;
}

std::map<std::string, std::string> places_in(const json& entries) {
  std::map<std::string, std::string> places;
  for (const auto& entry : entries.items()) places[entry.key()] = entry.value().at("place");
  return places;
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
  names["tables"] = keys_json(registered.tables);
  names["figures"] = json::object();
  for (const auto& [name, place] : figure_places(registered)) {
    names["figures"][name] = {{"place", place}};
  }
  names["excerpts"] = excerpts_json(excerpts);
  names["checks"] = checks_json(registered.checks);
  names["claims"] = claims_json(registered);
  names["imports"] = registered.attachments.digests();
  names["faults"] = faults(registered);
  names["files"] = files;
  return names.dump(2) + "\n";
}

Names read_names(const std::filesystem::path& file) {
  try {
    const json names = json::parse(sys::read_file(file));
    return {.values = keys_of(names.at("values")),
            .flags = names.at("flags").get<std::map<std::string, bool>>(),
            .tables = names.at("tables").get<std::set<std::string>>(),
            .figures = keys_of(names.at("figures")),
            .excerpts = keys_of(names.at("excerpts")),
            .claims = keys_of(names.at("claims")),
            .figure_places = places_in(names.at("figures")),
            .faults = names.at("faults").get<std::vector<std::string>>(),
            .files = names.at("files").get<std::vector<std::string>>()};
  } catch (const json::exception& error) {
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
