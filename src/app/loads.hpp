// SPDX-License-Identifier: GPL-3.0-or-later
// The pressure on a surface that --shape names.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "app/flags.hpp"
#include "config/units.hpp"
#include "elasticity/concentrated_load.hpp"
#include "elasticity/load.hpp"
#include "elasticity/load_shapes.hpp"
#include "elasticity/triangular_load.hpp"

namespace app {

/// A load whose displacements have a closed form.
using Shape = std::variant<elasticity::TriangularLoad, elasticity::UniformLoad,
                           elasticity::LinearFall, elasticity::ConcentratedLoad>;

struct ChosenLoad {
  elasticity::Load load;
  std::optional<Shape> shape = {};  ///< none for a file or a formula
  std::string source = {};          ///< reference of the closed form
  /// The pressure at these x, linear between them and zero outside: a fine sample of a formula;
  /// empty for a concentrated force.
  std::vector<double> x = {}, pressure = {};

  /// The greatest |x| of the load.
  double reach() const;

  /// The jump of the pressure at x, from left to right; infinite at a concentrated force. At a jump
  /// the gradient of the surface is infinite and stresses have no limit.
  double jump_at(double x) const;
};

/// The shapes that a command knows, as a number of the first ones in the list: all but those from
/// files and formulas and the concentrated force, all but the concentrated force, or all.
enum Shapes : std::size_t { named = 3, of_finite_width = 5, any = 6 };

/// The flags that describe a load.
struct LoadFlags {
  LoadFlags(CLI::App& command, const std::string& names, Shapes shapes);

  /// The flag with its text, for messages.
  std::string name() const { return "--shape " + shape.text_or("triangular"); }

  /// The load; flags override the case. Throws sys::InputError for an unknown shape, and for flags
  /// that the shape lacks, cannot use, or does not allow.
  ChosenLoad read(const std::optional<elasticity::TriangularLoad>& from_case,
                  const config::UnitSystem& units) const;

  Shapes shapes;
  Flag shape, peak_pressure, half_width;
  std::optional<Flag> line_load;  ///< if a concentrated force is among the shapes
};

}  // namespace app
