// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>

#include "literate/figures/plot.hpp"

namespace literate {

/// A figure to be drawn: its size, and the function that writes its script.
struct Figure {
  double width_cm = 0;
  double height_cm = 0;
  std::function<void(Plot&)> draw;
};

/// Runs `gnuplot name.gp` in the folder and checks that it wrote name.tex and name.pdf. The same
/// script gives the same bytes on any day and for any user. Throws sys::ToolError with gnuplot's
/// «"name.gp" line N: message», also if that is only a warning, as for a curve without points.
void run_gnuplot(const std::filesystem::path& folder, const std::string& name);

/// Writes the scripts of all figures one after the other, then runs gnuplot on them in parallel.
/// If several fail, throws the error of the figure whose name comes first.
void draw_figures(const std::filesystem::path& folder,
                  const std::map<std::string, Figure>& figures);

}  // namespace literate
