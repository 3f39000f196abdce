// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/displacement_table.hpp"
#include "elasticity/load.hpp"
#include "elasticity/material.hpp"

namespace app {

/// A load of the surface and the closed forms that stand beside its integrals.
struct ComparedLoad {
  elasticity::Load load;  ///< counts its evaluations

  /// At x; each empty where there is none.
  std::function<double(double)> normal_gradient, normal_displacement;
  std::function<double(double)> tangential_gradient, tangential_displacement;

  std::string normal_source;       ///< of the normal closed forms; empty if there are none
  std::vector<double> key_points;  ///< kinks, what lies between them, and one outside each end
  std::shared_ptr<long> n_evaluations;
};

/// What the command line and the case say about the load.
struct LoadChoice {
  std::string shape;  ///< triangular, uniform, elliptic, parabolic, concentrated, file:… or
                      ///< expression:…
  std::optional<double> peak_pressure, half_width, line_load;
  std::vector<double> kinks;  ///< of an expression, besides 0
};

/// Which flags the shape makes use of.
struct LoadFlags {
  bool peak_pressure, half_width, line_load, kinks;
};
LoadFlags flags_of(const std::string& shape);

/// Builds the load. Throws sys::InputError or InvalidQuantity for a shape that is unknown, what it
/// lacks, a file or an expression that is wrong.
ComparedLoad compared_load(const LoadChoice& choice, const elasticity::Material& material,
                           double datum);

/// Both ways to the numbers at a point.
DisplacementRow compare_at(const ComparedLoad& compared,
                           const elasticity::SurfaceQuadrature& surface, Component component,
                           double x);

}  // namespace app
