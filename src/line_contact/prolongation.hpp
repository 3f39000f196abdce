// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "line_contact/grid.hpp"

namespace line_contact {

/// The pressure of a coarse grid at the nodes of a fine one, none of them one-sided: linear between
/// nodes in contact, cubic where four of them are, and like a square root at the edge, which
/// regions_in_contact() places. 0 outside contact.
Eigen::VectorXd prolongate(const Grid& coarse, const Eigen::VectorXd& pressure, const Grid& fine);

}  // namespace line_contact
