// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "line_contact/element.hpp"
#include "line_contact/profile.hpp"

namespace line_contact {

/// Evenly spaced nodes, each with an element of its own: on both sides of a centre, or on the side
/// x ≥ 0 alone with mirror images on the other.
///
/// With triangles of half-width `spacing` (Fig. 2 of the paper) the pressure is linear between
/// nodes.
struct Grid {
  Eigen::Index n_nodes;
  double spacing;             ///< c, a length
  double centre = 0;          ///< x midway between the end nodes; 0 if one-sided
  bool is_one_sided = false;  ///< nodes x_i = i c, and mirror images of all but x_0

  double x(Eigen::Index i) const {
    if (is_one_sided) return static_cast<double>(i) * spacing;
    return centre + (static_cast<double>(i) - static_cast<double>(n_nodes - 1) / 2) * spacing;
  }
  Eigen::VectorXd nodes() const;

  /// How many elements node i stands for: 2 with a mirror image, else 1.
  double weight(Eigen::Index i) const { return is_one_sided && i > 0 ? 2 : 1; }

  /// The ends of the elements' spacings: the domain within which contact can be found.
  double begin() const { return is_one_sided ? -end() : x(0) - spacing / 2; }
  double end() const { return x(n_nodes - 1) + spacing / 2; }
};

/// The least number of nodes that can hold a contact with a free node on either side.
inline constexpr Eigen::Index min_nodes = 5;

/// The most that any method takes; the dense ones are content with fewer (see max_dense_nodes).
inline constexpr Eigen::Index max_nodes = Eigen::Index{1} << 24;

/// A grid of n_nodes a little wider than a contact of the expected half-width: a tenth of it and
/// one spacing on either side. Throws InvalidQuantity for fewer than min_nodes nodes, more than
/// max_nodes, or a half_width that is not > 0.
Grid grid_around(double half_width, Eigen::Index n_nodes);

/// n_nodes in the middle of as many spacings that together fill `width` about `centre`.
Grid grid_of_width(double width, Eigen::Index n_nodes, double centre = 0);

/// The same domain −width/2 ≤ x ≤ width/2 with n_nodes on x ≥ 0 and mirror images of them.
Grid one_sided_grid(double width, Eigen::Index n_nodes);

/// Two bodies to be pressed together, and the elements to find their pressure with. What remains
/// to be said is how hard: by the load P, or by the approach δ.
///
/// Where the bodies touch, u_z1 + u_z2 + h = δ and p ≥ 0. This is eq. (1a) of the paper.
/// Elsewhere u_z1 + u_z2 + h > δ and p = 0. This is eq. (1b) of the paper.
struct Problem {
  Profile profile;
  double contact_modulus;  ///< E*, a stress
  Grid grid;
  Element element = Element::triangular;
};

/// Lengths whose squares are doubles too, with room to add them up.
inline constexpr double largest_length = 1e100;

/// Throws InvalidQuantity unless E* > 0, the grid lies within a measured profile, the profile of a
/// one-sided grid is symmetric, all gaps are less than largest_length, and the largest of them is 0
/// or at least 1e-130, so that its square is no rounded zero.
void require_valid(const Problem& problem);

}  // namespace line_contact
