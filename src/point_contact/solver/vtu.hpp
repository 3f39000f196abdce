// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <string>

#include "point_contact/solver/solution.hpp"

namespace point_contact {

/// A solution as a VTU file (VTK's XML unstructured grid, appended raw data) for ParaView: the
/// nodes at z = 0; triangles between them for pyramids and staggered rows, else quadrilaterals;
/// point data `pressure` and `gap`, and `shear` if there is one at every node.
std::string vtu(const Solution& solution, const Eigen::VectorXd& shear = {});

}  // namespace point_contact
