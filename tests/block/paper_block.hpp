// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "block/analysis.hpp"
#include "elasticity/loads.hpp"

/// The block, material and printed displacements of Ruggiero (2001), Appendix 2, in inches and psi.
namespace paper_block {

inline const elasticity::Material material(30e6, 0.30);
inline const block::Rectangle rectangle(2, 1);
inline constexpr double half_width = 0.010;

/// x and the eleven measures with their sign reversed: u_z positive into the body, seven digits.
inline const std::vector<std::pair<double, double>> printed{
    {0.000, 1.594637e-06}, {0.005, 1.523029e-06}, {0.010, 1.328265e-06}, {0.015, 1.146614e-06},
    {0.020, 1.046848e-06}, {0.025, 9.728517e-07}, {0.030, 9.145697e-07}, {0.035, 8.661087e-07},
    {0.040, 8.238028e-07}, {0.045, 7.869750e-07}, {0.050, 7.545242e-07}};

inline block::RefinedSolution solve(const elasticity::Load& load, const block::Supports& supports,
                                    const block::Discretization& discretization = {}) {
  return block::Analysis(rectangle, material, {load}, discretization).on(supports).solve(load);
}

inline numerics::Estimate measure(const std::vector<block::MeasureEstimate>& measures,
                                  const std::string& name) {
  return std::ranges::find(measures, name, &block::MeasureEstimate::name)->value;
}

}  // namespace paper_block
