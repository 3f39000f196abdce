// SPDX-License-Identifier: GPL-3.0-or-later
// The bodies that are loaded or pressed together, with their materials and radii, and the pressure
// on a surface that --shape names.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "app/flags.hpp"
#include "config/units.hpp"
#include "elasticity/loads.hpp"
#include "elasticity/material.hpp"
#include "line_contact/cylinders.hpp"
#include "parameters/case.hpp"

namespace app {

using elasticity::Material;

/// The flags --young and --poisson, of one body or of both.
struct MaterialFlags {
  CLI::App& command;
  std::string number = "";           ///< number of the body, appended to the flags' names
  std::string which = " [210 GPa]";  ///< ends the help of --young: the body and the default
  std::string whose = " [0.3]";      ///< the same for --poisson
  Flag young{command, "--young" + number, "STRESS", "Bodies", "Young's modulus" + which};
  Flag poisson{command, "--poisson" + number, "NUMBER", "Bodies", "Poisson's ratio" + whose};
};

/// The material of a body. Each number comes from the first of the flags that was given, else from
/// the case, else from steel, which is then added to `assumed`. Throws sys::InputError for a number
/// out of range.
Material material_of(const std::vector<const MaterialFlags*>& flags,
                     const std::optional<Material>& from_case, const std::string& unit,
                     std::vector<std::string>& assumed);

/// The flags of two bodies' materials.
struct PairOfMaterialFlags {
  CLI::App& command;
  MaterialFlags both{command, "", " of both bodies [210 GPa]", " of both bodies [0.3]"};
  MaterialFlags body1{command, "1", " of body 1 alone", " of body 1 alone"};
  MaterialFlags body2{command, "2", " of body 2 alone", " of body 2 alone"};

  std::pair<Material, Material> read(const std::optional<parameters::ContactCase>& from_case,
                                     const std::string& unit,
                                     std::vector<std::string>& assumed) const;
};

/// A line that lists the assumptions; empty if there are none.
std::vector<std::string> note_of(const std::vector<std::string>& assumed);

/// The radius from a flag: a length other than 0, negative for a hollow, or "plane".
std::optional<line_contact::Radius> radius_of(const Flag& flag, const std::string& unit);

/// A warning if the contact's half-width is not small compared with the least radius of curvature
/// (0 if unknown): the error of the half-space approximation is of the order of the ratio squared.
std::vector<std::string> half_space_warnings(double half_width, double least_radius);

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

/// How many of the shapes in bodies.cpp a command accepts, from the first on: those with a name and
/// a width, also those from files and formulas, or also the concentrated force.
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
