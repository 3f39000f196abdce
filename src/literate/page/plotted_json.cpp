// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/page/plotted_json.hpp"

#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "literate/figures/plotted.hpp"
#include "literate/text/latex.hpp"
#include "system/files.hpp"

namespace literate {
namespace fs = std::filesystem;
namespace {

using nlohmann::json;

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

}  // namespace

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

}  // namespace literate
