// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "line_contact/element.hpp"
#include "line_contact/profile.hpp"

namespace line_contact {

/// Evenly spaced nodes about a centre, each with an element.
///
/// Triangles of half-width `spacing` (Fig. 2 of the paper) make the pressure linear between nodes.
struct Grid {
  Eigen::Index n_nodes;
  double spacing;     ///< c, a length
  double centre = 0;  ///< x midway between the end nodes

  double x(Eigen::Index i) const {
    return centre + (static_cast<double>(i) - static_cast<double>(n_nodes - 1) / 2) * spacing;
  }
  Eigen::VectorXd nodes() const;

  /// The ends of the domain, half a spacing beyond the end nodes.
  double begin() const { return x(0) - spacing / 2; }
  double end() const { return x(n_nodes - 1) + spacing / 2; }
  double width() const { return static_cast<double>(n_nodes) * spacing; }
};

/// The fewest nodes that allow a contact with a free node on either side, and the most of any
/// method, at 90 bytes per node. The dense methods take fewer (contact::max_dense_nodes).
inline constexpr Eigen::Index min_nodes = 10;
inline constexpr Eigen::Index max_nodes = Eigen::Index{1} << 24;

/// A grid of n_nodes that extends beyond a contact of the expected half-width by a tenth of it and
/// one spacing on either side. Throws InvalidQuantity for n_nodes outside [min_nodes, max_nodes]
/// and a half_width that is not > 0.
Grid grid_around(double half_width, Eigen::Index n_nodes);

/// n_nodes in the middles of n_nodes spacings that together fill `width` about `centre`. Throws
/// what grid_around throws.
Grid grid_of_width(double width, Eigen::Index n_nodes, double centre = 0);

/// Two bodies to be pressed together, and the elements that represent their pressure.
///
/// Where the bodies touch, u_z1 + u_z2 + h = δ and p ≥ 0. This is eq. (1a) of the paper.
/// Elsewhere u_z1 + u_z2 + h > δ and p = 0. This is eq. (1b) of the paper.
struct Problem {
  Profile profile;
  double contact_modulus;  ///< E*, a stress
  Grid grid;
  Element element = Element::triangular;
};

/// Throws InvalidQuantity unless E* > 0, the grid lies within a measured profile, all gaps are less
/// than contact::largest_length, and the greatest gap is 0 or at least 1e-130, so that its square
/// does not underflow.
void require_valid(const Problem& problem);

}  // namespace line_contact
