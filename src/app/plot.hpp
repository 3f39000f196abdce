// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures by gnuplot, in a file or as characters in the terminal.
#pragma once

#include <string>
#include <vector>

#include "app/flags.hpp"

namespace app {

/// A curve of a picture. Both columns have the same length; NaN breaks the curve.
struct Curve {
  std::string title;
  bool is_line;  ///< else a point at each pair
  std::vector<double> x, y;
};

/// Curves and the labels of the axes, with their units.
struct Picture {
  std::string x_label, y_label;
  std::vector<Curve> curves;
};

/// Throws sys::InputError unless a picture can be drawn where the flag says: "-" is the terminal; a
/// file must end with .svg, .png or .pdf, and its folder must exist.
void require_drawable(const Flag& where);

/// Draws the picture; a file takes its place when it is whole. Throws sys::ToolError if gnuplot
/// fails or is missing.
void draw(const Picture& picture, const std::string& where);

}  // namespace app
