// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/page/page_data.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string_view>
#include <vector>

#include "literate/page/plotted_json.hpp"
#include "literate/text/unit.hpp"
#include "system/error.hpp"
#include "system/files.hpp"
#include "system/parallel.hpp"

namespace literate {
namespace fs = std::filesystem;
namespace {

using nlohmann::json;

json values_of(const json& names) {
  json values = json::object();
  for (const auto& entry : names.at("values").items()) {
    json& value = values[entry.key()];
    for (const char* part :
         {"printed", "number", "abs_error", "below", "above", "standard", "unit", "exact", "percent", "place"})
      if (entry.value().contains(part)) value[part] = entry.value().at(part);
    if (value.contains("unit")) value["unit"] = plain_unit(value.at("unit").get<std::string>());
  }
  return values;
}

json file_of(const fs::path& path, const std::string& name) {
  return {{"name", name}, {"text", sys::read_file(path)}};
}

json figure_of(const fs::path& folder, const std::string& name, const std::string& place) {
  json data = json::array();
  std::vector<std::string> files = sys::files_below(folder);
  std::ranges::sort(files);
  for (const std::string& file : files) {
    if (file.ends_with(".csv")) {
      data.push_back(file_of(folder / file, fmt::format("{}-{}", name, file)));
    }
  }
  return {{"place", place},
          {"data", std::move(data)},
          {"script", file_of(folder / "script.gp", name + ".gp")}};
}

json figures_of(const json& names, const fs::path& folder, const fs::path& kept) {
  std::vector<std::string> figures;
  for (const auto& entry : names.at("figures").items()) figures.push_back(entry.key());
  std::vector<std::string> plotted(figures.size());
  sys::for_each_parallel(figures.size(), 0, [&](std::size_t i) {
    plotted[i] = plotted_json(folder / figures[i], figures[i], kept);
  });

  json result = json::object();
  for (std::size_t i = 0; i < figures.size(); ++i) {
    const std::string& name = figures[i];
    result[name] = figure_of(folder / name, name, names.at("figures").at(name).at("place"));
    result[name]["panels"] = json::parse(plotted[i]);
  }
  return result;
}

json tables_of(const json& names, const fs::path& folder) {
  json tables = json::object();
  for (const auto& entry : names.at("places").at("tables").items()) {
    const std::string file = entry.key() + ".csv";
    tables[entry.key()] = {{"place", entry.value()},
                           {"data", json::array({file_of(folder / file, file)})}};
  }
  return tables;
}

/// JSON that HTML takes for nothing else: an element or a comment begins with «<».
std::string for_html(const std::string& text) {
  std::string escaped;
  escaped.reserve(text.size());
  for (const char c : text) {
    if (c == '<') {
      escaped += "\\u003c";
    } else {
      escaped += c;
    }
  }
  return escaped;
}

}  // namespace

std::string page_data(const fs::path& generated, const fs::path& kept) {
  const fs::path file = generated / "names.json";
  try {
    const json names = json::parse(sys::read_file(file));
    json data{{"values", values_of(names)},
              {"figures", figures_of(names, generated / "figures", kept)},
              {"tables", tables_of(names, generated / "tables")}};
    if (!data["figures"].empty()) {
      data["style"] = file_of(generated / "figures" / "style.gp", "style.gp");
    }
    return for_html(data.dump()) + "\n";
  } catch (const json::exception& error) {
    throw sys::OutputError(
        fmt::format("'{}' is not what `compute` writes: {}", file.string(), error.what()));
  }
}

}  // namespace literate
