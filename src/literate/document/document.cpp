// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/document/document.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <stdexcept>
#include <utility>

#include "literate/document/document_tex.hpp"
#include "literate/document/ledger.hpp"
#include "literate/document/names.hpp"
#include "literate/document/page_html.hpp"
#include "literate/document/registered.hpp"
#include "literate/text/characters.hpp"
#include "literate/text/latex.hpp"
#include "system/error.hpp"
#include "system/files.hpp"
#include "system/nearest_name.hpp"
#include "system/staging.hpp"

namespace literate {
namespace fs = std::filesystem;

void Document::remember(const std::string& kind, const std::string& name,
                        const SourcePlace& place) {
  const auto [entry, is_new] = registered_.places.try_emplace({kind, name}, place);
  if (is_new) {
    remember_last_registered(fmt::format("{} '{}' ({})", kind, name, text_of(place)));
    return;
  }
  throw std::logic_error(fmt::format("{}: {} '{}' is registered twice, first at {}", text_of(place),
                                     kind, name, text_of(entry->second)));
}

void Document::append(Document part) {
  for (const auto& [kind_and_name, place] : part.registered_.places) {
    remember(kind_and_name.first, kind_and_name.second, place);
  }
  registered_.attachments.add(part.registered_.attachments);
  registered_.values.merge(part.registered_.values);
  registered_.flags.merge(part.registered_.flags);
  registered_.tables.merge(part.registered_.tables);
  registered_.figures.merge(part.registered_.figures);
  std::ranges::move(part.registered_.checks, std::back_inserter(registered_.checks));
  std::ranges::move(part.registered_.claims, std::back_inserter(registered_.claims));
}

namespace {

template <class T>
const T& registered_as(const std::map<std::string, T>& all, const char* kind,
                       const std::string& name, const std::source_location& location) {
  const auto found = all.find(name);
  if (found != all.end()) return found->second;
  std::set<std::string> names;
  for (const auto& [known, registered] : all) names.insert(known);
  throw std::invalid_argument(fmt::format("{}: no {} '{}' is registered{}",
                                          text_of(place_of(location)), kind, name,
                                          sys::suggestion(name, names)));
}

}  // namespace

const Value& Document::value(const std::string& key, Location location) const {
  return registered_as(registered_.values, "value", key, location);
}

const Table& Document::table(const std::string& name, Location location) const {
  return registered_as(registered_.tables, "table", name, location);
}

void Document::value(const std::string& key, Value value, Location location) {
  this->value(key, std::move(value), place_of(location));
}

void Document::value(const std::string& key, Value value, const SourcePlace& place) {
  require_key(key);
  try {
    value.require_finite();
    value.require_error();
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(
        fmt::format("{}: value '{}': {}", text_of(place), key, error.what()));
  }
  remember("value", key, place);
  registered_.values.emplace(key, std::move(value));
}

void Document::flag(const std::string& key, bool is_set, Location location) {
  require_key(key);
  remember("flag", key, place_of(location));
  registered_.flags.emplace(key, is_set);
}

void Document::table(Table table, Location location) {
  this->table(std::move(table), place_of(location));
}

void Document::table(Table table, const SourcePlace& place) {
  const std::string name = table.name();
  require_file_name(name);
  table.require_complete();
  remember("table", name, place);
  registered_.tables.emplace(name, std::move(table));
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
  registered_.figures.emplace(name, std::move(figure));
}

void Document::check(const std::string& id, const std::vector<Criterion>& criteria,
                     std::string statement, Location location) {
  if (criteria.empty()) {
    throw std::logic_error(
        fmt::format("{}: check '{}' has no criterion", text_of(place_of(location)), id));
  }
  check(id, verdict_of(criteria) == Verdict::confirmed, std::move(statement), location);
  registered_.checks.back().found = literate::text_of(criteria);
}

void Document::check(const std::string& id, bool passed, std::string statement, Location location) {
  require_key(id);
  remember("check", id, place_of(location));
  registered_.checks.push_back({id, passed, std::move(statement), {}});
}

void Document::claim(const std::string& id, Claim claim, Location location) {
  require_key(id);
  remember("claim", id, place_of(location));
  const auto require = [&](bool is_there, const char* part) {
    if (is_there) return;
    throw std::logic_error(
        fmt::format("{}: claim '{}' has no {}", text_of(place_of(location)), id, part));
  };
  require(!claim.route.empty(), "route");
  require(!claim.criteria.empty(), "criterion");
  std::set<std::string> names;
  for (const Criterion& criterion : claim.criteria) {
    if (names.insert(criterion.name()).second) continue;
    throw std::logic_error(
        fmt::format("{}: claim '{}' has two criteria that are called '{}'; each needs a name of "
                    "its own",
                    text_of(place_of(location)), id, criterion.name()));
  }
  registered_.claims.emplace_back(id, std::move(claim));
}

void Document::write(const fs::path& output_dir, const std::vector<Excerpt>& excerpts) const {
  sys::Staging staging(output_dir);
  sys::write_file_atomically(staging.path() / "literate.sty", literate_sty);
  sys::write_file_atomically(staging.path() / "values.tex", values_tex(registered_));
  sys::write_file_atomically(staging.path() / "claims.tex", claims_tex(registered_));
  sys::write_file_atomically(staging.path() / "claims.csv", claims_csv(registered_));
  sys::write_file_atomically(staging.path() / "index.tex", index_tex(registered_));
  sys::write_file_atomically(staging.path() / "values.csv", values_csv(registered_));
  sys::write_file_atomically(staging.path() / "sources.csv", sources_csv(registered_));
  for (const auto& [name, table] : registered_.tables) {
    sys::write_file_atomically(staging.path() / "tables" / (name + ".tex"), table.latex());
    sys::write_file_atomically(staging.path() / "tables" / (name + ".csv"), table.csv());
  }
  sys::write_file_atomically(staging.path() / "excerpts" / "characters.def", listings_characters());
  for (const Excerpt& excerpt : excerpts) write_excerpt(staging.path() / "excerpts", excerpt);
  for (const auto& [name, figure] : registered_.figures) {
    write_figure(staging.path() / "figures" / name, name, figure);
  }
  registered_.attachments.write(staging.path() / "imports");
  sys::write_file_atomically(staging.path() / "provenance.tex",
                             provenance_tex(registered_, staging.path()));
  write_page_parts(registered_, staging.path());

  std::vector<std::string> files = staging.files();
  files.emplace_back("names.json");
  std::ranges::sort(files);
  sys::write_file_atomically(staging.path() / "names.json",
                             names_json(registered_, excerpts, files));
  staging.publish(former_files(output_dir / "names.json"));
}

}  // namespace literate
