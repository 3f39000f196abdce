// SPDX-License-Identifier: GPL-3.0-or-later
// Types and functions for public checks and tasks. This header is part of the handout, so it uses
// the standard library only.
#pragma once

#include <cstddef>
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

/// Computes the answer of a task for the inputs from index `first` on: `compute` gets each input and
/// the answer, to which it appends.
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
