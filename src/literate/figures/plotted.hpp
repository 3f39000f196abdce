// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace literate {

/// An axis of a drawing as gnuplot chose it. `at_start` stands left or below, and is the greater
/// one where the axis is reversed.
struct PlottedAxis {
  std::string label;  ///< LaTeX; may be empty
  double at_start = 0;
  double at_end = 1;
  bool is_logarithmic = false;
};

/// A curve as gnuplot drew it: abscissae and ordinates in the units of the axes, without those that
/// are undefined or outside.
struct PlottedCurve {
  std::string title;  ///< LaTeX; empty for a curve that the key does not name
  std::vector<std::pair<double, double>> points;
};

/// One pair of axes in a drawing, of which several panels may have several. Its frame is given in
/// shares of the drawing's width and height, from the left and from below.
struct PlottedPanel {
  double left = 0, right = 1, bottom = 0, top = 1;
  PlottedAxis x, y;
  std::vector<PlottedCurve> curves;
};

/// What a figure that `draw` has drawn shows, and where: for readers who point at it. gnuplot runs
/// the script twice more, in an empty folder `scratch`, once for the frames and once for the
/// points.
///
/// Empty where that cannot be told: maps of colours and surfaces, curves against a second axis, and
/// plots that do not begin a line of the script. `folder` is the figure's among the generated ones,
/// which holds name.gp, script.gp and the data; ../style.gp lies beside it. Throws sys::ToolError
/// if there is no gnuplot, sys::OutputError if a file is missing.
std::vector<PlottedPanel> plotted_panels(const std::filesystem::path& folder,
                                         const std::string& name,
                                         const std::filesystem::path& scratch);

/// How many points of its data a figure does not show, since a range of its script leaves them out;
/// 0 where gnuplot cannot list them. `folder` and `scratch` are those of plotted_panels.
std::size_t n_points_outside(const std::filesystem::path& folder, const std::string& name,
                             const std::filesystem::path& scratch);

/// The blocks of data that were registered for a figure and that its script does not name outside
/// lines of comment; none for a script that makes names up by value(). `folder` is that of
/// plotted_panels.
std::vector<std::string> unread_blocks(const std::filesystem::path& folder);

/// A script that says to gnuplot's messages, after each plot, which frame and axes it had.
std::string telling_axes(const std::string& script);

/// A script that draws nothing on pages of several panels, so that a table holds its points with
/// ten digits. `before_plots` are more lines before each plot.
std::string telling_points(const std::string& script, const std::string& before_plots = {});

}  // namespace literate
