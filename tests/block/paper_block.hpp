// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "block/analysis.hpp"
#include "block/fit.hpp"
#include "block/rectangle.hpp"
#include "elasticity/load_shapes.hpp"
#include "elasticity/material.hpp"

/// The block, material and printed results of Ruggiero (2001), Appendix 2, in inches and psi.
namespace paper_block {

inline const elasticity::Material material(30e6, 0.30);
inline const block::Rectangle rectangle(2, 1);
inline constexpr double half_width = 0.010;

/// The eleven measures, with their sign turned: u_z positive into the body, seven digits.
inline const std::vector<block::SurfaceDisplacement> printed{
    {0.000, 1.594637e-06}, {0.005, 1.523029e-06}, {0.010, 1.328265e-06}, {0.015, 1.146614e-06},
    {0.020, 1.046848e-06}, {0.025, 9.728517e-07}, {0.030, 9.145697e-07}, {0.035, 8.661087e-07},
    {0.040, 8.238028e-07}, {0.045, 7.869750e-07}, {0.050, 7.545242e-07}};

inline block::MeasureOptions measure_options() {
  block::MeasureOptions options;
  for (const auto& point : printed) options.surface_points.push_back(point.x);
  const double a = half_width;
  options.singular_discs = {{-a, 0, a / 10}, {a, 0, a / 10}, {-1, 0, 0.1},
                            {1, 0, 0.1},     {-1, 1, 0.1},   {1, 1, 0.1}};
  return options;
}

inline double measure(const std::vector<block::MeasureEstimate>& measures,
                      const std::string& name) {
  for (const auto& measure : measures) {
    if (measure.name == name) return measure.value.value;
  }
  throw std::out_of_range(name);
}

}  // namespace paper_block
