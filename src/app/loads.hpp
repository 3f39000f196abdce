// SPDX-License-Identifier: GPL-3.0-or-later
// The pressure on a surface that --shape names.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/flags.hpp"
#include "config/units.hpp"
#include "elasticity/loads.hpp"
#include "elasticity/material.hpp"

namespace app {

/// Functions of x on the surface; empty where no closed form is known.
struct ClosedForms {
  std::function<double(double)> normal_gradient, normal_displacement;
  std::function<double(double)> tangential_gradient, tangential_displacement;
};

/// A load with its closed forms and samples.
struct ChosenLoad {
  elasticity::Load load;
  std::string source = {};  ///< reference of the closed forms; empty if there are none
  std::function<ClosedForms(const elasticity::Material&, double datum)> closed_forms = {};
  /// The pressure at these x, linear between them and zero outside: a fine sample of a formula;
  /// empty for a concentrated force.
  std::vector<double> x = {}, pressure = {};

  /// The greatest |x| of the load.
  double reach() const;

  /// The jump of the pressure at x, from left to right; infinite at a concentrated force. At a jump
  /// the gradient of the surface is infinite and stresses have no limit.
  double jump_at(double x) const;
};

enum class Shapes { any, of_finite_width, without_input };

/// The flags that describe a load.
struct LoadFlags {
  LoadFlags(CLI::App& command, const std::string& names, Shapes shapes);

  /// The flag with its text, for messages.
  std::string name() const { return "--shape " + shape.text_or("triangular"); }

  /// The load; flags override the case. Throws sys::InputError for an unknown shape, and for flags
  /// that the shape lacks, cannot use, or does not allow.
  ChosenLoad read(const std::optional<elasticity::TriangularLoad>& from_case,
                  const config::UnitSystem& units) const;

  std::vector<std::string> shapes;
  Flag shape, peak_pressure, half_width;
  std::optional<Flag> line_load;  ///< if a concentrated force is among the shapes
};

}  // namespace app
