// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "point_contact/solver/solution.hpp"

namespace point_contact {

/// A part of the surface in contact whose nodes are neighbours of one another.
struct Region {
  Vector2 centre;  ///< of its pressure
  double load;     ///< what it carries, a force
  double area;     ///< of its nodes' cells
  Eigen::Index n_nodes;
};

/// The regions in contact, those that carry most first. Neighbours of a node are the six at
/// ±first, ±second and ±(second − first), the corners of a pyramid's hexagon.
std::vector<Region> regions(const Solution& solution);

}  // namespace point_contact
