// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/document/folder.hpp"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <vector>

#include "literate/document/ledger.hpp"
#include "literate/document/results_json.hpp"
#include "literate/document/values_tex.hpp"
#include "system/files.hpp"

namespace literate {
namespace fs = std::filesystem;
namespace {

constexpr const char* results_name = "results.json";

/// The files that an earlier run wrote; none if its list cannot be read.
std::vector<std::string> earlier_files(const fs::path& folder) {
  std::error_code error;
  if (!fs::is_regular_file(folder / results_name, error)) return {};
  const auto json = nlohmann::json::parse(sys::read_file(folder / results_name), nullptr, false);
  std::vector<std::string> files;
  if (!json.is_object() || !json.contains("files") || !json["files"].is_array()) return files;
  for (const auto& file : json["files"]) {
    const fs::path name = file.is_string() ? fs::path(file.get<std::string>()) : fs::path();
    // An edited list must not reach other folders.
    const bool is_inside = name.is_relative() && std::ranges::find(name, "..") == name.end();
    if (!name.empty() && is_inside) files.push_back(name.generic_string());
  }
  return files;
}

std::map<std::string, std::string> files_of(const Document& document,
                                            const std::string& case_name) {
  std::map<std::string, std::string> files{{"values.tex", values_tex(document, case_name)},
                                           {"ledger.tex", ledger_tex(document)},
                                           {"values.csv", values_csv(document)},
                                           {"claims.csv", claims_csv(document)},
                                           {"tables.csv", tables_csv(document)}};
  for (const auto& [name, table] : document.tables()) {
    files["tables/" + name + ".tex"] = table.latex();
    files["tables/" + name + ".csv"] = table.csv();
  }
  for (const auto& [name, figure] : document.figures()) {
    const std::string folder = "figures/" + name + "/";
    files[folder + "data.gp"] = figure_prelude(name, figure);
    for (const auto& [block, data] : figure.data) files[folder + block + ".csv"] = figure_csv(data);
  }
  return files;
}

}  // namespace

void write_folder(const Document& document, const fs::path& folder, const std::string& case_name) {
  const std::map<std::string, std::string> files = files_of(document, case_name);
  std::vector<std::string> names;
  names.reserve(files.size());
  for (const auto& [name, text] : files) names.push_back(name);
  const std::string results = results_json(document, case_name, names);

  const std::vector<std::string> earlier = earlier_files(folder);
  for (const auto& [name, text] : files) sys::write_if_changed(folder / name, text);
  for (const std::string& name : earlier) {
    if (!files.contains(name) && name != results_name) sys::remove_file(folder / name);
  }
  sys::write_if_changed(folder / results_name, results);
}

}  // namespace literate
