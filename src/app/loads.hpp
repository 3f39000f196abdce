// SPDX-License-Identifier: GPL-3.0-or-later
// The pressure on a surface that --shape names.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/flags.hpp"
#include "config/units.hpp"
#include "elasticity/load.hpp"
#include "elasticity/material.hpp"
#include "elasticity/triangular_load.hpp"

namespace app {

/// Functions of x on the surface; empty where no closed form is known.
struct ClosedForms {
  std::function<double(double)> normal_gradient, normal_displacement;
  std::function<double(double)> tangential_gradient, tangential_displacement;
};

/// A load, and what is known of it.
struct ChosenLoad {
  elasticity::Load load;
  std::string source = {};  ///< of the closed forms; empty for none
  std::function<ClosedForms(const elasticity::Material&, double datum)> closed_forms = {};
  /// The pressure at these places, linear between and zero outside: of a formula a fine sample;
  /// empty for a concentrated force.
  std::vector<double> x = {}, pressure = {};

  /// The greatest |x| at which it acts.
  double reach() const;

  /// By how much the pressure jumps at x, from left to right; infinite at a concentrated force.
  /// Where it does, the gradient of the surface is infinite and stresses have no limit.
  double jump_at(double x) const;
};

enum class Shapes { any, of_finite_width, without_input };

/// The flags that describe a load.
struct LoadFlags {
  LoadFlags(CLI::App& command, const std::string& names, Shapes shapes);

  /// The shape as it was given.
  std::string name() const { return "--shape " + shape.text_or("triangular"); }

  /// The flags override the case. Throws sys::InputError for a shape that is unknown, and for what
  /// it lacks, has no use for, or cannot be.
  ChosenLoad read(const std::optional<elasticity::TriangularLoad>& from_case,
                  const config::UnitSystem& units) const;

  std::vector<std::string> shapes;
  Flag shape, peak_pressure, half_width;
  std::optional<Flag> line_load;  ///< if a concentrated force is among the shapes
};

}  // namespace app
