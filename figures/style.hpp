// SPDX-License-Identifier: GPL-3.0-or-later
// What all figures have in common.
#pragma once

#include <string>
#include <vector>

#include "literate/figures/plot.hpp"

namespace figures {

/// Line styles 1 to 4 (solid, dashed, dotted, dash-dotted; from dark to light) and point styles 11
/// to 13 (circle, square, cross): told apart in greyscale as well as in colour. Axes left and
/// below only, tics outside, a faint grid.
void apply_style(literate::Plot& plot);

/// For schematic figures: no axes, tics or key, one unit as long on both axes.
void apply_schematic_style(literate::Plot& plot);

/// A factor that brings an axis to numbers of convenient size, and the unit that this makes.
struct AxisScale {
  double factor;     ///< multiply data by it
  std::string unit;  ///< LaTeX, such as $10^{-6}$\,in
};

/// The scale for data up to `largest` in `unit`: an exponent that is a multiple of three, none from
/// 0.01 to 1000.
AxisScale axis_scale(double largest, const std::string& unit);

/// The distance of ticks, 1, 2 or 5 times a power of ten, that puts two to four of them on an axis
/// from 0 to `largest`; 1 for an axis without length.
double tick_step(double largest);

/// Each number times the factor.
std::vector<double> scaled(const std::vector<double>& numbers, double factor);

/// The largest magnitude, NaN aside; 0 for none.
double largest_magnitude(const std::vector<double>& numbers);

}  // namespace figures
