// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/choices.hpp"
#include "elasticity/load_shapes.hpp"

namespace app {

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

/// The numbers that were given, and what `from_case` has of the others.
elasticity::LoadNumbers numbers_of(const ChoiceOption& given, elasticity::LoadNumbers from_case);

}  // namespace app
