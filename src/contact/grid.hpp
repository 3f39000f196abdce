// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace contact {

/// Evenly spaced nodes that lie symmetrically about the point of first contact.
///
/// Node i is at x = (i − (n_nodes − 1)/2)·spacing. Each carries a triangle of half-width `spacing`
/// (Fig. 2 of the paper), so the pressure is linear between nodes.
struct Grid {
  Eigen::Index n_nodes;
  double spacing;  ///< c, a length

  double x(Eigen::Index i) const {
    return (static_cast<double>(i) - static_cast<double>(n_nodes - 1) / 2) * spacing;
  }
  Eigen::VectorXd nodes() const;
};

/// The least number of nodes that can hold a contact with a free node on either side.
inline constexpr Eigen::Index min_nodes = 5;

/// A grid of n_nodes a little wider than a contact of the expected half-width: a tenth of it and
/// one spacing on either side. Throws InvalidQuantity for fewer than min_nodes nodes, more than
/// max_nodes, or a half_width that is not > 0.
Grid grid_around(double half_width, long n_nodes);

/// The largest dense problem: its matrix takes 8 bytes times the square, here 0.8 GB.
inline constexpr long max_nodes = 10'000;

}  // namespace contact
