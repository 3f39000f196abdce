// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/page/page.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <boost/algorithm/string/replace.hpp>
#include <nlohmann/json.hpp>
#include <string_view>
#include <vector>

#include "literate/figures/plotted.hpp"
#include "literate/text/latex.hpp"
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
    for (const char* part : {"printed", "number", "abs_error", "below", "above", "standard", "unit",
                             "exact", "percent", "place"})
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

constexpr std::size_t most_points = 1000;

json axis_json(const PlottedAxis& axis) {
  return {{"label", plain_text(axis.label)},
          {"start", axis.at_start},
          {"end", axis.at_end},
          {"log", axis.is_logarithmic}};
}

json curve_json(const PlottedCurve& curve) {
  json points = json::array();
  const std::size_t step = 1 + (curve.points.size() - 1) / most_points;
  for (std::size_t i = 0; i < curve.points.size(); i += step) {
    points.push_back(curve.points[i].first);
    points.push_back(curve.points[i].second);
  }
  return {{"title", plain_text(curve.title)}, {"points", std::move(points)}};
}

json panel_json(const PlottedPanel& panel) {
  json curves = json::array();
  for (const PlottedCurve& curve : panel.curves) {
    if (!curve.points.empty()) curves.push_back(curve_json(curve));
  }
  return {{"frame", {panel.left, panel.right, panel.bottom, panel.top}},
          {"x", axis_json(panel.x)},
          {"y", axis_json(panel.y)},
          {"curves", std::move(curves)}};
}

// What the panels of a drawn figure show, as JSON. It is kept with a digest of all that it was
// drawn from. A curve of more than a thousand points keeps every second of them, or third, and so
// on.
std::string plotted_json(const fs::path& folder, const std::string& name, const fs::path& kept) {
  // The record of the drawing has the digests of script, style, data and gnuplot; the first line is
  // another one when this file writes another form.
  const std::string digest =
      sys::sha256_of_text("form 2\n" + sys::read_file(folder / "drawn.sha256")) + "\n";
  const fs::path file = kept / (name + ".json");
  if (fs::is_regular_file(file)) {
    const std::string former = sys::read_file(file);
    if (former.starts_with(digest)) return former.substr(digest.size());
  }
  const fs::path scratch = kept / (name + ".part");
  fs::remove_all(scratch);
  json panels = json::array();
  for (const PlottedPanel& panel : plotted_panels(folder, name, scratch)) {
    panels.push_back(panel_json(panel));
  }
  fs::remove_all(scratch);
  const std::string text = panels.dump();
  sys::write_file_atomically(file, digest + text);
  return text;
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
  return boost::replace_all_copy(text, "<", "\\u003c");
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
