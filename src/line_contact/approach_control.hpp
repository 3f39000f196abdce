// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "line_contact/solution.hpp"

namespace line_contact {

/// A method that solves a problem under a given load.
using Method = std::function<Solution(const Problem&, double line_load)>;

/// Solves the contact of two bodies that have approached each other by δ, measured where the
/// surfaces lie at x = datum (both lengths; u_z1 = u_z2 = 0 there).
///
/// δ(P) rises with the load P; the root is found by the secant rule for ln P against ln(δ − h_min),
/// on a coarse grid first. The load is right to 1e-12 or, if that is worse, to the method's own
/// tolerance. Throws InvalidQuantity if δ is not greater than the least gap (the bodies do not
/// touch then) or the datum lies in the grid, and what the method throws.
Solution solve_for_approach(const Problem& problem, double approach, double datum,
                            const Method& method);

}  // namespace line_contact
