// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "point_contact/solver/grid.hpp"

namespace point_contact {

/// Pressures on a fine grid from those on a coarser one of the same domain, 0 outside contact.
///
/// At the edge of a contact p² begins linearly, so it is p² that is interpolated bilinearly, after
/// it was continued linearly across the edge, where it becomes negative.
Eigen::VectorXd prolongate(const Grid& coarse, const Eigen::VectorXd& pressure, const Grid& fine);

}  // namespace point_contact
