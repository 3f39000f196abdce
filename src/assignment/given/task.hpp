// SPDX-License-Identifier: GPL-3.0-or-later
// This header is part of the handout, so it uses the standard library only.
#pragma once

#include <cstddef>
#include <string>

#include "course/assignment/check.hpp"

namespace assignment {

/// One task of the student's program, `build/assignment NAME`: numbers in, numbers out, all in SI
/// units.
struct Task {
  std::string name;
  std::string takes;     ///< the inputs in their order, such as "E ν p₀ a x₁ x₂ …"
  std::string gives;     ///< the answer, such as "∂u_z/∂x at each x"
  std::size_t n_inputs;  ///< the least number of inputs
  course::Numbers (*run)(const course::Numbers& inputs);  ///< calls the student's function
};

/// The answer to the numbers from `first` on, each of which `compute` takes with the answer to
/// append to.
template <class Compute>
course::Numbers for_each_from(std::size_t first, const course::Numbers& in,
                              const Compute& compute) {
  course::Numbers out;
  for (std::size_t i = first; i < in.size(); ++i) compute(in[i], out);
  return out;
}

}  // namespace assignment
