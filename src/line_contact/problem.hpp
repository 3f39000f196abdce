// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "line_contact/element.hpp"
#include "line_contact/profile.hpp"

namespace line_contact {

/// Evenly spaced nodes about a centre, each with an element.
///
/// With triangles of half-width `spacing` (Fig. 2 of the paper) the pressure is linear between
/// nodes.
struct Grid {
  Eigen::Index n_nodes;
  double spacing;     ///< c, a length
  double centre = 0;  ///< x midway between the end nodes

  double x(Eigen::Index i) const {
    return centre + (static_cast<double>(i) - static_cast<double>(n_nodes - 1) / 2) * spacing;
  }
  Eigen::VectorXd nodes() const;

  /// The ends of the elements' spacings: the domain within which contact can be found.
  double begin() const { return x(0) - spacing / 2; }
  double end() const { return x(n_nodes - 1) + spacing / 2; }
  double width() const { return static_cast<double>(n_nodes) * spacing; }
};

/// The fewest nodes that can hold a contact with a free node on either side, and the most that any
/// method takes: 90 bytes each. The dense methods take fewer (contact::max_dense_nodes).
inline constexpr Eigen::Index min_nodes = 10;
inline constexpr Eigen::Index max_nodes = Eigen::Index{1} << 24;

/// A grid of n_nodes a little wider than a contact of the expected half-width: a tenth of it and
/// one spacing on either side. Throws InvalidQuantity for fewer than min_nodes nodes, more than
/// max_nodes, or a half_width that is not > 0.
Grid grid_around(double half_width, Eigen::Index n_nodes);

/// n_nodes in the middle of as many spacings that together fill `width` about `centre`.
Grid grid_of_width(double width, Eigen::Index n_nodes, double centre = 0);

/// Two bodies to be pressed together, and the elements to find their pressure with.
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
/// than contact::largest_length, and the greatest of them is 0 or at least 1e-130, so that its
/// square is no rounded zero.
void require_valid(const Problem& problem);

}  // namespace line_contact
