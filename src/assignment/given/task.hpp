// SPDX-License-Identifier: GPL-3.0-or-later
// What public checks and tasks share. This header is part of the handout, so it uses the standard
// library only.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "assignment/given/numbers.hpp"
#include "judge/check.hpp"
#include "judge/tally.hpp"

namespace assignment {

using judge::at;
using judge::greatest;
using judge::joined;
using judge::near;
using judge::Numbers;
using judge::Outcome;
using judge::Program;
using judge::Tally;
using judge::times;

/// One task of the student's program: numbers in, numbers out, all in SI units.
struct Task {
  std::string name;
  std::string takes;     ///< the inputs in their order, such as "E ν p₀ a x₁ x₂ …"
  std::string gives;     ///< the answer, such as "∂u_z/∂x at each x"
  std::size_t n_inputs;  ///< the least number of inputs
  Numbers (*run)(const Numbers& inputs);  ///< calls the student's function
};

/// The answer for the numbers from `first` on: `compute` takes each with the answer to append to.
template <class Compute>
Numbers for_each_from(std::size_t first, const Numbers& in, const Compute& compute) {
  Numbers out;
  for (std::size_t i = first; i < in.size(); ++i) compute(in[i], out);
  return out;
}

/// A check of this assignment, with the id that assignment.toml lists.
struct Check {
  std::string id;
  Outcome (*outcome)(const Program& program, const OwnNumbers& own);
};

using Checks = std::vector<Check>;

/// The checks for these numbers, as a judge takes them.
inline std::vector<judge::Check> bound(const Checks& checks, const OwnNumbers& own) {
  std::vector<judge::Check> result;
  for (const Check& check : checks) {
    result.push_back({check.id, [outcome = check.outcome, own](const Program& program) {
                        return outcome(program, own);
                      }});
  }
  return result;
}

/// Allows for a few roundings and for the digits that a sum of logarithms loses near the load.
inline constexpr double roundings = 1e-9;

}  // namespace assignment
