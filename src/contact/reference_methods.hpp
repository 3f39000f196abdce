// SPDX-License-Identifier: GPL-3.0-or-later
// Two methods that are independent of the bodies: they solve line and point contacts alike.
#pragma once

#include <Eigen/Core>
#include <functional>

namespace contact {

/// A frictionless contact as equations with coefficients of order one. The nodal loads φ_j ≥ 0 add
/// up to `total` and leave the gaps g = h − δ − Tφ ≥ 0; at each node φ or g is 0.
struct Equations {
  Eigen::VectorXd initial_gap;  ///< h, less than 1e100
  double total;
  double smallest_gap = 0;  ///< the rounding error of a gap in contact
};

/// The solution that a method finds.
struct ContactLoads {
  Eigen::VectorXd phi;
  Eigen::VectorXd gap;
  double approach = 0;  ///< δ
  double misfit = 0;    ///< greatest |gap| in contact
  int solves = 0;       ///< solutions of the linear system
  int products = 0;     ///< products with T
};

/// Matrix inversion: solves eq. (1a) at the nodes in contact, with equilibrium, as one linear
/// system. Starts with every node in contact; nodes in tension leave the contact and nodes that
/// penetrate enter it until neither occurs. Cost n³ for n nodes.
///
/// T(i, j) is minus the displacement at node i due to a unit load on element j. Throws ContactError
/// if the contact does not settle.
ContactLoads invert(const Equations& equations,
                    const std::function<double(Eigen::Index i, Eigen::Index j)>& influence);

/// The variational method: among all φ ≥ 0 that carry the total, finds the one of least energy −½
/// φᵀTφ + hᵀφ (Kalker 1972; Johnson 5.9), by the constrained conjugate gradients of Polonsky & Keer
/// (1999), Wear 231, 206. It assumes no contact and searches for none.
///
/// `displace` sets u = −Tφ. The iteration ends when no gap in contact and no penetration exceeds
/// the greater of smallest_gap and tolerance·max φ. Throws ContactError if that takes max_products
/// products or more.
ContactLoads minimise(
    const Equations& equations,
    const std::function<void(const Eigen::VectorXd& phi, Eigen::VectorXd& u)>& displace,
    double tolerance, int max_products);

}  // namespace contact
