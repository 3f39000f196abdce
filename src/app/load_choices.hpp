// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/choices.hpp"
#include "elasticity/load_shapes.hpp"
#include "elasticity/material.hpp"
#include "elasticity/triangular_load.hpp"

namespace app {

/// The numbers that may describe a load; a shape takes those that it needs.
struct LoadNumbers {
  std::optional<double> peak_pressure;  ///< p₀, a stress
  std::optional<double> half_width;     ///< a, a length
  std::optional<double> line_load;      ///< P, force per unit length
  std::optional<double> parameter;      ///< of the shape, such as an exponent
};

/// One of them: its name, such as "peak-pressure", and what it is.
struct LoadNumber {
  std::string name;
  std::string meaning;
  std::optional<double> LoadNumbers::*number;
};

/// All but the parameter.
const std::vector<LoadNumber>& load_numbers();

/// The surface of a half-space under a load in closed form, functions of x; each is empty where no
/// closed form is known.
struct ClosedSurface {
  std::function<double(double)> normal_gradient, normal_displacement;
  std::function<double(double)> tangential_gradient, tangential_displacement;
};

/// A load and, if that is known, the surface beneath it with u_z(datum) = 0.
struct KnownLoad {
  elasticity::Load load;
  std::function<ClosedSurface(const elasticity::Material&, double datum)> surface = nullptr;
};

/// The closed forms of a load such as TriangularLoad: its functions of this namespace.
template <class Shape>
std::function<ClosedSurface(const elasticity::Material&, double)> closed_surface_of(const Shape& load) {
  return [load](const elasticity::Material& material, double datum) {
    ClosedSurface surface;
    surface.normal_gradient = [=](double x) { return normal_gradient(material, load, x); };
    surface.normal_displacement = [=](double x) {
      return normal_displacement(material, load, x, datum);
    };
    if constexpr (requires { tangential_displacement(material, load, 0.0); }) {
      surface.tangential_gradient = [=, any = elasticity::Load(load)](double x) {
        return tangential_gradient(material, any, x);
      };
      surface.tangential_displacement = [=](double x) {
        return tangential_displacement(material, load, x);
      };
    }
    return surface;
  };
}

/// A load that has a name.
struct LoadShape {
  std::string name;       ///< such as "uniform"
  std::string parameter;  ///< what LoadNumbers::parameter is, such as "EXPONENT"; empty for none
  std::vector<std::string> numbers;  ///< the names of the others that it needs
  std::string source;                ///< of the closed forms, such as "eq. (3)"; empty without them
  std::function<KnownLoad(const LoadNumbers&)> make;  ///< throws InvalidQuantity
};

/// All of them. What names, asks for or lists a load follows from this table.
const std::vector<LoadShape>& load_shapes();

/// The function of x that a formula spells, such as p0*(1-(x/a)^4): muParser's operators and
/// functions (sin, sqrt, abs, exp, ln, min, …), pi, and these constants. The function throws
/// sys::InputError naming x where the formula has no finite value. `what` begins the messages.
///
/// Throws sys::InputError naming the column of the formula where it is wrong. A decimal point is
/// one in every locale.
std::function<double(double)> parse_expression(const std::string& what, const std::string& formula,
                                               const std::map<std::string, double>& constants);

/// A load that a flag such as --shape names: those of elasticity::load_shapes(), one from a file
/// and one from a formula.
struct LoadChoice : Choice {
  std::string source;  ///< of the closed forms; empty if there are none
  /// Makes the load. Throws sys::InputError or InvalidQuantity for a number that is missing or a
  /// file or an expression that is wrong.
  std::function<KnownLoad(const ChoiceOption& given,
                                      const LoadNumbers& numbers)>
      make;
};

/// All of them, in the order of the help. Their flags are --peak-pressure and the like.
const std::vector<LoadChoice>& load_choices();

/// Those of elasticity::load_shapes() that act on |x| ≤ a, without flags, for a command that takes
/// pressure and width from the case.
const std::vector<LoadChoice>& wide_load_choices();

/// The numbers of the case's own load.
LoadNumbers numbers_of(const elasticity::TriangularLoad& load);

/// The numbers that were given, and what `from_case` has of the others.
LoadNumbers numbers_of(const ChoiceOption& given, LoadNumbers from_case);

}  // namespace app
