// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "app/choices.hpp"
#include "elasticity/load_shapes.hpp"
#include "elasticity/triangular_load.hpp"

namespace app {

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
  std::function<elasticity::KnownLoad(const ChoiceOption& given,
                                      const elasticity::LoadNumbers& numbers)>
      make;
};

/// All of them, in the order of the help. Their flags are --peak-pressure and the like.
const std::vector<LoadChoice>& load_choices();

/// Those of elasticity::load_shapes() that act on |x| ≤ a, without flags, for a command that takes
/// pressure and width from the case.
const std::vector<LoadChoice>& wide_load_choices();

/// The numbers of the case's own load.
elasticity::LoadNumbers numbers_of(const elasticity::TriangularLoad& load);

/// The numbers that were given, and what `from_case` has of the others.
elasticity::LoadNumbers numbers_of(const ChoiceOption& given, elasticity::LoadNumbers from_case);

}  // namespace app
