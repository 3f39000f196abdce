// SPDX-License-Identifier: GPL-3.0-or-later
// What contacts of lines and of points have in common in what they refuse, and when they warn.
#pragma once

#include <Eigen/Core>
#include <string>

namespace contact {

/// Lengths whose squares are doubles too, with room to add them up.
inline constexpr double largest_length = 1e100;

/// The largest dense problem: its matrix takes 8 bytes times the square, here 0.8 GB.
inline constexpr Eigen::Index max_dense_nodes = 10'000;

/// Throws InvalidQuantity unless least ≤ tolerance ≤ 0.01. `tolerance` is the error allowed to the
/// nodal pressures, relative to the greatest; `least` is what rounding allows.
double require_tolerance(double tolerance, double least);

/// How a contact lies on its grid.
struct Resolution {
  Eigen::Index n_in_contact;  ///< nodes in contact
  double n_across;            ///< of them along the contact's diameter
  Eigen::Index n_nodes;       ///< nodes of the grid along a side of the domain
  double domain;              ///< that side, a length
};

/// A contact of fewer nodes carries any load without a residual, and its pressure means nothing.
inline constexpr Eigen::Index least_nodes_in_contact = 8;

/// Throws InvalidQuantity for fewer than least_nodes_in_contact. The message says how many nodes,
/// or which domain, would do.
void require_resolved(const Resolution& resolution);

/// The error of width and greatest pressure, relative: of second order, measured against Hertz at
/// the worst of all places of the edge between two nodes.
double relative_error(const Resolution& resolution);

/// A sentence with the size of the error if fewer than 20 nodes lie across the contact, else empty.
std::string resolution_warning(const Resolution& resolution);

}  // namespace contact
