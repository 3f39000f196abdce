// SPDX-License-Identifier: GPL-3.0-or-later
// The accuracy of line and point contacts: limits of their input, resolution, residuals and cost.
#pragma once

#include <Eigen/Core>
#include <string>

namespace contact {

/// The upper limit of lengths, so that sums of their squares do not overflow.
inline constexpr double largest_length = 1e100;

/// The most nodes of a dense problem; its matrix takes 8 bytes times the square, 0.8 GB.
inline constexpr Eigen::Index max_dense_nodes = 10'000;

/// Returns the tolerance, or throws InvalidQuantity unless least ≤ tolerance ≤ 0.01. `tolerance` is
/// the allowed error of the nodal pressures relative to the peak; `least` is set by rounding.
double require_tolerance(double tolerance, double least);

/// How well a grid resolves a contact.
struct Resolution {
  Eigen::Index n_in_contact;  ///< nodes in contact
  double n_across;            ///< those along the contact's diameter
  Eigen::Index n_nodes;       ///< nodes of the grid along a side of the domain
  double domain;              ///< the length of that side
};

/// With fewer nodes, a contact carries any load without a residual and its pressure is meaningless.
inline constexpr Eigen::Index least_nodes_in_contact = 8;

/// Throws InvalidQuantity for fewer than least_nodes_in_contact. The message suggests a number of
/// nodes and a domain.
void require_resolved(const Resolution& resolution);

/// The relative error of the width and the peak pressure. It is of second order; its factor was
/// measured against Hertz with the edge at the worst place between two nodes.
double relative_error(const Resolution& resolution);

/// A warning with the size of the error if fewer than 20 nodes lie across the contact, else empty.
std::string resolution_warning(const Resolution& resolution);

/// How well a solution satisfies the conditions that define it. P is a force; for a line contact, a
/// force per unit length.
struct Residuals {
  double gap = 0;         ///< greatest |u_z1 + u_z2 + h − δ| in contact, eq. (1a), a length
  double separation = 0;  ///< greatest penetration outside, against eq. (1b), a length
  double pressure = 0;    ///< the method's estimate of its error in pressure, a stress
  double load = 0;        ///< |resultant − P|
};

/// The residuals of gap and separation, from the pressures and gaps at the nodes.
Residuals residuals_of_gaps(const Eigen::VectorXd& pressure, const Eigen::VectorXd& gap);

/// The cost of a solution on the finest grid.
struct Work {
  int revisions = 0;         ///< revisions of the contact until it settled
  int iterations = 0;        ///< steps of the conjugate gradients
  int products = 0;          ///< products with the influence coefficients
  int preconditionings = 0;  ///< products with the preconditioner; not counted for line contacts
};

}  // namespace contact
