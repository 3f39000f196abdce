// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/provenance/manifest.hpp"

#include <fmt/core.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <string_view>

#include "literate/values/decimal.hpp"
#include "system/error.hpp"
#include "system/files.hpp"

namespace literate {
namespace fs = std::filesystem;
namespace {

using nlohmann::json;

json numbers_json(const std::map<std::string, ManifestNumber>& numbers) {
  json entries = json::object();
  for (const auto& [key, value] : numbers) {
    entries[key] = {{"number", value.number}, {"printed", value.printed}};
    if (value.abs_error) entries[key]["abs_error"] = *value.abs_error;
    if (value.sides) {
      entries[key]["below"] = value.sides->first;
      entries[key]["above"] = value.sides->second;
    }
    if (value.standard != 0) entries[key]["standard"] = value.standard;
  }
  return entries;
}

/// The units of the numbers that have one.
Manifest::Texts units_of(const std::map<std::string, ManifestNumber>& numbers) {
  Manifest::Texts units;
  for (const auto& [key, number] : numbers) {
    if (number.unit && !number.unit->empty()) units[key] = *number.unit;
  }
  return units;
}

/// Reads numbers as numbers_json and names.json write them; leaves out values without a number.
std::map<std::string, ManifestNumber> numbers_of(const json& values) {
  std::map<std::string, ManifestNumber> numbers;
  for (const auto& [key, value] : values.items()) {
    // JSON has no infinity; such a number is null there and has no place in a manifest.
    if (!value.contains("number") || !value.at("number").is_number()) continue;
    ManifestNumber& number = numbers[key];
    number.number = value.at("number");
    number.printed = value.at("printed");
    if (value.contains("abs_error") && value.at("abs_error").is_number()) {
      number.abs_error = value.at("abs_error").get<double>();
    }
    if (value.contains("below")) number.sides = {value.at("below"), value.at("above")};
    number.standard = value.value("standard", 0.0);
    // What the law of propagation neglects is told with the bound where the law does not hold.
    const double neglected = value.value("neglected", 0.0);
    if (number.abs_error && neglected > number.standard) *number.abs_error += neglected;
  }
  return numbers;
}

json parsed(const std::string& text, const std::string& file) {
  try {
    return json::parse(text);
  } catch (const json::exception&) {
    throw sys::OutputError(fmt::format("'{}' is not JSON", file));
  }
}

/// What `read` takes from a names.json.
template <typename Read>
auto from_names(const fs::path& names_json, Read read) {
  try {
    return read(parsed(sys::read_file(names_json), names_json.string()));
  } catch (const json::exception&) {
    throw sys::OutputError(fmt::format("'{}' is not a list of names", names_json.string()));
  }
}

}  // namespace

Manifest::Texts digests(const fs::path& folder, const std::vector<std::string>& files,
                        const std::string& prefix) {
  Manifest::Texts texts;
  for (const std::string& file : files) texts[prefix + file] = sys::sha256_of_file(folder / file);
  return texts;
}

Manifest results_in(const fs::path& names_json, const std::string& project) {
  return from_names(names_json, [&](const json& names) {
    Manifest results;
    results.project = project;
    for (const char* part : {"values", "cells"}) {
      const std::string kind = part == std::string_view("values") ? "value " : "";
      for (const auto& [key, entry] : names.at(part).items()) {
        if (!entry.contains("number")) results.texts[kind + key] = entry.at("printed");
      }
      for (auto& [key, number] : numbers_of(names.at(part))) {
        number.unit = names.at(part).at(key).value("unit", "");
        results.numbers[key] = number;
      }
    }
    for (const auto& [flag, is_set] : names.at("flags").items()) {
      results.texts["flag " + flag] = is_set.get<bool>() ? "yes" : "no";
    }
    for (const auto& [id, claim] : names.at("claims").items()) {
      results.verdicts["claim " + id] = claim.at("found");
      for (const json& criterion : claim.at("criteria")) {
        const std::string quantity = criterion.at("name");
        const std::string what = fmt::format("claim {}: {}", id, quantity);
        results.limits[what] = criterion.at("limit");
        results.outcomes[what] = criterion.at("outcome");
        results.texts[what] = criterion.at("found");
      }
    }
    for (const auto& [id, check] : names.at("checks").items()) {
      results.verdicts["check " + id] = check.at("passed").get<bool>() ? "passed" : "failed";
    }
    results.words = names.at("words").get<Manifest::Texts>();
    return results;
  });
}

std::map<std::string, bool> flags_of(const Manifest& manifest) {
  constexpr std::string_view kind = "flag ";
  std::map<std::string, bool> flags;
  for (const auto& [name, text] : manifest.texts) {
    if (name.starts_with(kind)) flags[name.substr(kind.size())] = text == "yes";
  }
  return flags;
}

double bounds_between(const ManifestNumber& a, const ManifestNumber& b) {
  const bool is_below = a.number < b.number;
  const auto below = [](const ManifestNumber& n) {
    return n.sides ? n.sides->first : *n.abs_error;
  };
  const auto above = [](const ManifestNumber& n) {
    return n.sides ? n.sides->second : *n.abs_error;
  };
  const auto sum = [](double one, double other) { return decimal_difference(one, -other); };
  return is_below ? sum(above(a), below(b)) : sum(below(a), above(b));
}

bool have_other_units(const ManifestNumber& a, const ManifestNumber& b) {
  return a.unit && b.unit && *a.unit != *b.unit;
}

bool agree(const ManifestNumber& a, const ManifestNumber& b) {
  if (have_other_units(a, b)) return false;
  if (!a.abs_error || !b.abs_error) return a.printed == b.printed;
  return std::abs(decimal_difference(a.number, b.number)) <= bounds_between(a, b);
}

Manifest::Texts imported_files(const fs::path& names_json) {
  return from_names(names_json,
                    [](const json& names) { return names.at("imports").get<Manifest::Texts>(); });
}

std::string manifest_json(const Manifest& manifest) {
  json text{{"project", manifest.project},
            {"made_with", manifest.facts},
            {"inputs", manifest.inputs},
            {"outputs", manifest.outputs},
            {"numbers", numbers_json(manifest.numbers)},
            {"units", units_of(manifest.numbers)},
            {"verdicts", manifest.verdicts},
            {"limits", manifest.limits},
            {"texts", manifest.texts},
            {"outcomes", manifest.outcomes},
            {"words", manifest.words}};
  if (!manifest.ages.empty()) text["ages"] = manifest.ages;
  return text.dump(2) + "\n";
}

Manifest read_manifest(const fs::path& file, const std::string& project) {
  return manifest_of(sys::read_file(file), file.string(), project);
}

Manifest manifest_of(const std::string& json_text, const std::string& file,
                     const std::string& project) {
  const json text = parsed(json_text, file);
  try {
    if (text.at("project") != project) {
      throw sys::OutputError(fmt::format("'{}' is the manifest of another project, {}", file,
                                         text.at("project").dump()));
    }
    auto numbers = numbers_of(text.at("numbers"));
    if (text.contains("units")) {
      for (auto& [key, number] : numbers) number.unit = text.at("units").value(key, "");
    }
    return {.project = project,
            .facts = text.at("made_with").get<std::map<std::string, Manifest::Texts>>(),
            .inputs = text.at("inputs").get<Manifest::Texts>(),
            .outputs = text.at("outputs").get<Manifest::Texts>(),
            .numbers = numbers,
            .verdicts = text.at("verdicts").get<Manifest::Texts>(),
            .limits = text.value("limits", Manifest::Texts()),
            .texts = text.value("texts", Manifest::Texts()),
            .outcomes = text.value("outcomes", Manifest::Texts()),
            .words = text.value("words", Manifest::Texts()),
            .ages = text.value("ages", Manifest::Texts()),
            .is_of_earlier_version =
                !text.contains("limits") || !text.contains("texts") || !text.contains("outcomes")};
  } catch (const json::exception&) {
    throw sys::OutputError(fmt::format("'{}' is not a manifest", file));
  }
}

namespace {

/// Calls `differs(key, theirs, ours)` for each key whose entries are not the same; the pointer to
/// an entry that is missing is null.
template <typename Entries, typename IsSame, typename Differs>
void for_each_difference(const Entries& theirs, const Entries& ours, IsSame is_same,
                         Differs differs) {
  std::set<std::string> keys;
  for (const auto& entry : theirs) keys.insert(entry.first);
  for (const auto& entry : ours) keys.insert(entry.first);
  for (const std::string& key : keys) {
    const auto a = theirs.find(key);
    const auto b = ours.find(key);
    const auto* their_entry = a == theirs.end() ? nullptr : &a->second;
    const auto* our_entry = b == ours.end() ? nullptr : &b->second;
    if (their_entry == nullptr || our_entry == nullptr || !is_same(*their_entry, *our_entry)) {
      differs(key, their_entry, our_entry);
    }
  }
}

std::string text_or_none(const std::string* text) {
  return text == nullptr ? "none" : *text;
}

/// A number as a message tells it; a cell of a table is printed without its unit.
std::string printed_or_none(const std::string& name, const ManifestNumber* number) {
  if (number == nullptr) return "none";
  const std::string unit = number->unit.value_or("");
  const bool tells_unit = unit.empty() || !name.starts_with("table ");
  return fmt::format("{} ({}{})", number->number, number->printed, tells_unit ? "" : " " + unit);
}

}  // namespace

ManifestComparison compare(const Manifest& theirs, const Manifest& ours) {
  ManifestComparison result;
  const auto equal = [](const std::string& a, const std::string& b) { return a == b; };

  for_each_difference(
      theirs.outputs, ours.outputs, equal,
      [&](const std::string& file, auto*, auto*) { result.changed_outputs.push_back(file); });
  for (const auto& [part, facts] : ours.facts) {
    const auto their_part = theirs.facts.find(part);
    for_each_difference(their_part == theirs.facts.end() ? Manifest::Texts{} : their_part->second,
                        facts, equal,
                        [&](const std::string& name, const std::string* a, const std::string* b) {
                          result.reasons.push_back(fmt::format("{}: {} there, {} here", name,
                                                               text_or_none(a), text_or_none(b)));
                        });
  }
  for_each_difference(theirs.inputs, ours.inputs, equal,
                      [&](const std::string& file, auto* a, auto* b) {
                        result.reasons.push_back(fmt::format("{}: {}", file,
                                                             a == nullptr   ? "only here"
                                                             : b == nullptr ? "only there"
                                                                            : "another content"));
                      });
  for_each_difference(
      theirs.numbers, ours.numbers, agree,
      [&](const std::string& key, const ManifestNumber* a, const ManifestNumber* b) {
        result.moved.push_back(fmt::format("{}: {} there, {} here", key, printed_or_none(key, a),
                                           printed_or_none(key, b)));
      });
  for_each_difference(theirs.verdicts, ours.verdicts, equal,
                      [&](const std::string& name, const std::string* a, const std::string* b) {
                        result.moved.push_back(fmt::format("{}: {} there, {} here", name,
                                                           text_or_none(a), text_or_none(b)));
                      });
  const auto results_of = [](Manifest manifest) {
    manifest.facts = {};
    manifest.inputs = manifest.outputs = manifest.ages = {};
    return manifest_json(manifest);
  };
  result.has_same_results = results_of(theirs) == results_of(ours);
  return result;
}

}  // namespace literate
