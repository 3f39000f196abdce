// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "elasticity/load.hpp"
#include "elasticity/material.hpp"

namespace paper {

/// A symmetric pressure p(x) = end + (middle − end) f(|x|/a) on |x| ≤ a, with f(0) = 1. It is
/// linearised between nodes, which are densest in the middle and at the ends, and is therefore a
/// sum of triangles of eq. (4) with different half-widths and a uniform part.
class FallingPressure {
 public:
  /// f on [0, 1]; middle and end are stresses, half_width > 0 a length. For a curved f the
  /// resultant is accurate to 1e-4 relative.
  FallingPressure(const std::function<double(double)>& f, double middle, double end,
                  double half_width);

  double half_width() const { return half_width_; }

  /// ∫ p dx, force per unit length.
  double line_load() const;

  /// ∫ x² p dx over the resultant, a length squared.
  double second_moment() const;

  /// u_z at the surface of a half-space with u_z(datum) = 0, a length: eq. (3) for each triangle
  /// plus the closed form of the uniform part.
  double displacement(const elasticity::Material& material, double x, double datum) const;

  /// ½∫ p u dx over the loaded strip, energy per unit thickness, for a symmetric displacement u(x)
  /// of the surface.
  double work(const std::function<double(double)>& u) const;

  /// The largest |σ_xz| in a half-space, a stress, accurate to 1e-5 relative: searched on ever
  /// finer grids around the best point.
  double largest_shear() const;

  elasticity::Load load() const;

 private:
  double pressure(double x) const;

  std::function<double(double)> f_;
  double middle_, end_, half_width_;
  std::vector<double> nodes_;   // x ≥ 0, from 0 to a
  std::vector<double> values_;  // p there
};

}  // namespace paper
