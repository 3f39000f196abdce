// SPDX-License-Identifier: GPL-3.0-or-later
// Two methods that know nothing of the bodies: what they solve may be a contact of lines or of
// points.
#pragma once

#include <Eigen/Core>
#include <functional>

namespace contact {

/// A frictionless contact as equations with coefficients of order one. Nodal loads φ_j ≥ 0 carry
/// Σ φ_j = total and leave the gaps g = h − δ − Tφ ≥ 0; at each node one of the two is 0.
struct Equations {
  Eigen::VectorXd initial_gap;  ///< h, less than 1e100
  double total;
  double smallest_gap = 0;  ///< what rounding leaves of a gap in contact
};

/// What a method finds.
struct ContactLoads {
  Eigen::VectorXd phi;
  Eigen::VectorXd gap;
  double approach = 0;  ///< δ
  double misfit = 0;    ///< greatest |gap| in contact
  int solves = 0;       ///< of the linear system
  int products = 0;     ///< with T
};

/// Matrix inversion: eq. (1a) at the nodes in contact and equilibrium are one linear system; nodes
/// in tension leave the contact, nodes that penetrate enter it, until neither occurs. It begins
/// with every node in contact. Cost n³ for n nodes.
///
/// T(i, j) is −1 times the displacement at node i by the load 1 of element j. Throws ContactError
/// when the contact does not settle.
ContactLoads invert(const Equations& equations,
                    const std::function<double(Eigen::Index i, Eigen::Index j)>& influence);

/// The variational method: of all φ ≥ 0 that carry the total the one with the least energy
/// −½ φᵀTφ + hᵀφ (Kalker 1972; Johnson 5.9), by the constrained conjugate gradients of Polonsky &
/// Keer (1999), Wear 231, 206. No contact is assumed or searched for.
///
/// `displace` sets u = −Tφ. It ends when no gap in contact and no penetration exceed smallest_gap
/// or tolerance·max φ, and throws ContactError where that takes more than so many products.
ContactLoads minimise(
    const Equations& equations,
    const std::function<void(const Eigen::VectorXd& phi, Eigen::VectorXd& u)>& displace,
    double tolerance, int max_products);

}  // namespace contact
