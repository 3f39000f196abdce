// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/document.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "literate/characters.hpp"
#include "literate/error.hpp"
#include "literate/files.hpp"
#include "literate/latex.hpp"
#include "literate/literate_sty.hpp"
#include "literate/name.hpp"
#include "literate/names.hpp"
#include "literate/staging.hpp"

namespace literate {
namespace fs = std::filesystem;
namespace {

template <typename Content>
void insert(std::map<std::string, Content>& map, const char* kind, const std::string& name,
            Content content) {
  if (!map.try_emplace(name, std::move(content)).second) {
    throw std::logic_error(fmt::format("{} '{}' is registered twice", kind, name));
  }
}

/// Definitions of all values, as LaTeX and as text for PDF bookmarks, and of all flags.
std::string values_tex(const Document& document) {
  std::string text;
  for (const auto& [key, value] : document.values()) {
    text += fmt::format("\\LiterateValue{{{}}}{{{}}}{{{}}}\n", key, value.latex(),
                        escape_bookmark(value.printed()));
  }
  for (const auto& [key, is_set] : document.flags()) {
    text += fmt::format("\\LiterateFlag{{{}}}{{{}}}\n", key, is_set ? "true" : "false");
  }
  return text;
}

/// The files of the run before, which may be removed; none if it left no list.
std::vector<std::string> former_files(const fs::path& output_dir) {
  const fs::path list = output_dir / "names.json";
  if (!fs::exists(list)) return {};
  try {
    return read_names(list).files;
  } catch (const OutputError&) {
    return {};
  }
}

}  // namespace

void Document::value(const std::string& key, Value value) {
  require_key(key);
  insert(values_, "value", key, std::move(value));
}

void Document::flag(const std::string& key, bool is_set) {
  require_key(key);
  insert(flags_, "flag", key, is_set);
}

void Document::table(const std::string& name, Table table) {
  require_file_name(name);
  insert(tables_, "table", name, std::move(table));
}

void Document::figure(const std::string& name, double width_cm, double height_cm,
                      std::function<void(Plot&)> draw) {
  require_file_name(name);
  insert(figures_, "figure", name, Figure{width_cm, height_cm, std::move(draw)});
}

void Document::check(const std::string& id, bool passed, std::string statement) {
  require_key(id);
  if (std::ranges::find(checks_, id, &Check::id) != checks_.end()) {
    throw std::logic_error(fmt::format("check '{}' is registered twice", id));
  }
  checks_.push_back({id, passed, std::move(statement)});
}

std::vector<Check> Document::failed_checks() const {
  std::vector<Check> failed;
  std::ranges::copy_if(checks_, std::back_inserter(failed),
                       [](const Check& check) { return !check.passed; });
  return failed;
}

void Document::write(const fs::path& output_dir, const std::vector<Excerpt>& excerpts) const {
  Staging staging(output_dir);
  write_file_atomically(staging.path() / "literate.sty", literate_sty);
  write_file_atomically(staging.path() / "values.tex", values_tex(*this));
  for (const auto& [name, table] : tables_) {
    write_file_atomically(staging.path() / "tables" / (name + ".tex"), table.latex());
  }
  write_file_atomically(staging.path() / "excerpts" / "characters.def", listings_characters());
  for (const Excerpt& excerpt : excerpts) write_excerpt(staging.path() / "excerpts", excerpt);

  fs::create_directory(staging.path() / "figures");
  draw_figures(staging.path() / "figures", figures_);

  std::vector<std::string> files = staging.files();
  files.emplace_back("names.json");
  std::ranges::sort(files);
  write_file_atomically(staging.path() / "names.json", names_json(*this, excerpts, files));
  staging.publish(former_files(output_dir));
}

}  // namespace literate
