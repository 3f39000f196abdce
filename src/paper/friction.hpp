// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "line_contact/cylinders.hpp"
#include "line_contact/problem.hpp"
#include "line_contact/solution.hpp"
#include "paper/prelude.hpp"

namespace paper {

/// Two bodies with the case's radii, pressed to the case's half-width.
///
/// Lengths, loads and stresses in the case's units; `line_load` is a force per length, `beta` is
/// Dundurs's second constant, without dimension.
struct Pair {
  line_contact::CylinderPair cylinders;
  double line_load;
  Hertz hertz;
  line_contact::Problem problem;
  line_contact::Solution solution;
  double beta;
};

/// The pair of these two materials, solved without friction by matrix inversion on the case's
/// nodes. The load is the case's times the ratio of the contact moduli, so that Hertz's half-width
/// is the case's. Throws what solve_by_matrix_inversion() throws.
Pair pair_of(const ContactCase& c, const elasticity::Material& first,
             const elasticity::Material& second);

}  // namespace paper
