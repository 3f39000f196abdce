// SPDX-License-Identifier: GPL-3.0-or-later
// Shared by the hidden checks of exercises 2 and 3.
#pragma once

#include <string>

#include "assignment/given/shapes.hpp"
#include "assignment/given/task.hpp"

namespace assignment {

/// The number of a pressure, and the abscissas x/a at which the surface is tested.
struct Places {
  double shape;
  Numbers xi;
};

/// The number of a pressure that is in no handout, so that a program fails if it knows only the
/// named shapes.
inline double waves(const OwnNumbers& own) {
  return 4 + 12 * own.poisson2;
}

inline std::string place(double xi, double shape) {
  return at("x/a", xi) + (shape < shape::fewest_waves ? at(", pressure", shape) : ", waves");
}

}  // namespace assignment
