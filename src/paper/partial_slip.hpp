// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "paper/friction_pair.hpp"
#include "paper/prelude.hpp"

namespace paper {

/// Registers what the section on friction says of partial slip: shear and strip that sticks under
/// three tangential loads, beside Cattaneo and Mindlin, and the orders of their errors.
///
/// `own` is the case's pair of bodies, `mu` their coefficient of friction, greater than 0. Throws
/// what line_contact::partial_slip() and line_contact::solve_by_matrix_inversion() throw.
void compute_partial_slip(Document& document, const ContactCase& c, const Pair& own, double mu,
                          bool is_papers_case);

}  // namespace paper
