// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/document/document.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "literate/document/document_tex.hpp"
#include "literate/document/literate_sty.hpp"
#include "literate/document/names.hpp"
#include "literate/text/characters.hpp"
#include "literate/text/name.hpp"
#include "system/error.hpp"
#include "system/files.hpp"
#include "system/staging.hpp"

namespace literate {
namespace fs = std::filesystem;

void Document::remember(const std::string& kind, const std::string& name,
                        const SourcePlace& place) {
  const auto [entry, is_new] = places_.try_emplace({kind, name}, place);
  if (is_new) return;
  throw std::logic_error(fmt::format("{}: {} '{}' is registered twice, first at {}", text_of(place),
                                     kind, name, text_of(entry->second)));
}

void Document::append(Document part) {
  for (const auto& [kind_and_name, place] : part.places_) {
    remember(kind_and_name.first, kind_and_name.second, place);
  }
  values_.merge(part.values_);
  flags_.merge(part.flags_);
  tables_.merge(part.tables_);
  figures_.merge(part.figures_);
  std::ranges::move(part.checks_, std::back_inserter(checks_));
  std::ranges::move(part.claims_, std::back_inserter(claims_));
}

void Document::value(const std::string& key, Value value, Location location) {
  require_key(key);
  remember("value", key, place_of(location));
  values_.emplace(key, std::move(value));
}

void Document::flag(const std::string& key, bool is_set, Location location) {
  require_key(key);
  remember("flag", key, place_of(location));
  flags_.emplace(key, is_set);
}

void Document::table(const std::string& name, Table table, Location location) {
  require_file_name(name);
  remember("table", name, place_of(location));
  tables_.emplace(name, std::move(table));
}

void Document::figure(const std::string& name, Figure figure, Location location) {
  require_file_name(name);
  remember("figure", name, place_of(location));
  try {
    require_drawable(figure);
  } catch (const std::logic_error& error) {
    throw std::logic_error(
        fmt::format("{}: figure '{}': {}", text_of(place_of(location)), name, error.what()));
  }
  figures_.emplace(name, std::move(figure));
}

void Document::check(const std::string& id, bool passed, std::string statement, Location location) {
  require_key(id);
  remember("check", id, place_of(location));
  checks_.push_back({id, passed, std::move(statement)});
}

void Document::claim(const std::string& id, Claim claim, Location location) {
  require_key(id);
  remember("claim", id, place_of(location));
  const std::array<std::pair<const char*, const std::string*>, 5> parts{
      {{"sentence", &claim.sentence},
       {"place", &claim.place},
       {"computed value", &claim.computed.printed()},
       {"route", &claim.route},
       {"tolerance", &claim.tolerance}}};
  for (const auto& [part, text] : parts) {
    if (!text->empty()) continue;
    throw std::logic_error(
        fmt::format("{}: claim '{}' has no {}", text_of(place_of(location)), id, part));
  }
  claims_.emplace_back(id, std::move(claim));
}

const SourcePlace& Document::place(const std::string& kind, const std::string& name) const {
  return places_.at({kind, name});
}

std::vector<std::string> Document::faults() const {
  std::vector<std::string> faults;
  for (const Check& check : failed_checks()) {
    faults.push_back(fmt::format("check {} failed: {}", check.id, check.statement));
  }
  for (const auto& [id, claim] : claims_) {
    if (claim.found == claim.expected) continue;
    faults.push_back(fmt::format("claim {} is {}, not {}: {} Stated: {}; computed: {}", id,
                                 name_of(claim.found), name_of(claim.expected), claim.sentence,
                                 claim.stated.printed().empty() ? "-" : claim.stated.printed(),
                                 claim.computed.printed()));
  }
  return faults;
}

std::map<std::string, std::string> Document::figure_places() const {
  std::map<std::string, std::string> places;
  for (const auto& [name, figure] : figures_) places[name] = text_of(place("figure", name));
  return places;
}

std::vector<Check> Document::failed_checks() const {
  std::vector<Check> failed;
  std::ranges::copy_if(checks_, std::back_inserter(failed),
                       [](const Check& check) { return !check.passed; });
  return failed;
}

void Document::write(const fs::path& output_dir, const std::vector<Excerpt>& excerpts) const {
  sys::Staging staging(output_dir);
  sys::write_file_atomically(staging.path() / "literate.sty", literate_sty);
  sys::write_file_atomically(staging.path() / "values.tex", values_tex(*this));
  sys::write_file_atomically(staging.path() / "claims.tex", claims_tex(*this));
  sys::write_file_atomically(staging.path() / "index.tex", index_tex(*this));
  for (const auto& [name, table] : tables_) {
    sys::write_file_atomically(staging.path() / "tables" / (name + ".tex"), table.latex());
    sys::write_file_atomically(staging.path() / "tables" / (name + ".csv"), table.csv());
  }
  sys::write_file_atomically(staging.path() / "excerpts" / "characters.def", listings_characters());
  for (const Excerpt& excerpt : excerpts) write_excerpt(staging.path() / "excerpts", excerpt);
  for (const auto& [name, figure] : figures_) {
    write_figure(staging.path() / "figures" / name, name, figure);
  }
  sys::write_file_atomically(staging.path() / "provenance.tex",
                             provenance_tex(*this, staging.path()));

  std::vector<std::string> files = staging.files();
  files.emplace_back("names.json");
  std::ranges::sort(files);
  sys::write_file_atomically(staging.path() / "names.json", names_json(*this, excerpts, files));
  staging.publish(former_files(output_dir / "names.json"));
}

}  // namespace literate
