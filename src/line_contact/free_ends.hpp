// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "line_contact/problem.hpp"

namespace line_contact {

/// Throws InvalidQuantity if contact reaches an end of the grid, which then hides part of it: the
/// pressures (in any unit) are > 0 there. It says what domain the load needs, found on a coarse
/// grid, or that the profile is not given that far out.
void require_free_ends(const Problem& problem, const Eigen::VectorXd& pressure, double line_load);

}  // namespace line_contact
