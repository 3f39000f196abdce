// SPDX-License-Identifier: GPL-3.0-or-later
// Types and functions for public checks and tasks. This header is part of the handout, so it uses
// the standard library only.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "assignment/given/bodies.hpp"
#include "judge/check.hpp"

namespace assignment {

using judge::at;
using judge::Checks;
using judge::greatest;
using judge::joined;
using judge::near;
using judge::Numbers;
using judge::Outcome;
using judge::Program;
using judge::Tally;
using judge::times;

/// A task of the student's program. Inputs and answer are numbers in SI units.
struct Task {
  std::string name;
  std::string takes;     ///< the inputs in order, such as "E ν p₀ a x₁ x₂ …"
  std::string gives;     ///< the answer, such as "∂u_z/∂x at each x"
  std::size_t n_inputs;  ///< the minimum number of inputs
  Numbers (*run)(const Numbers& inputs);  ///< calls the student's function
};

/// Computes the answer for the inputs from index `first` on: `compute` gets each input and the
/// answer, to which it appends.
template <class Compute>
Numbers for_each_from(std::size_t first, const Numbers& in, const Compute& compute) {
  Numbers out;
  for (std::size_t i = first; i < in.size(); ++i) compute(in[i], out);
  return out;
}

/// A relative tolerance for rounding errors and for the digits that a sum of logarithms loses near
/// the load.
inline constexpr double roundings = 1e-9;

}  // namespace assignment
