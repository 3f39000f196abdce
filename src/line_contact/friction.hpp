// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "line_contact/solution.hpp"
#include "line_contact/solver.hpp"

namespace line_contact {

/// What friction adds to a contact whose pressure is known: the shear traction, uncoupled, which
/// means that its effect on the pressure is neglected (exactly none for β = 0).
struct Friction {
  Eigen::VectorXd shear;   ///< q at the nodes, stress, positive along x on body 1
  double tangential_load;  ///< Q, force per unit length
  double stick_load;  ///< what the contact would carry whose pressure is taken away; 0: sliding
};

/// Sliding: q = μp everywhere, Q = μP. Throws InvalidQuantity unless μ is finite and ≥ 0.
Friction sliding(const Solution& solution, double friction_coefficient);

/// Partial slip under a tangential load |Q| < μP that follows the normal one: the theorem of
/// Ciavarella and Jäger, q = ±μ[p(P) − p(P − |Q|/μ)], for any profile and alike materials (Johnson
/// 7.2 for cylinders). The second pressure is that of the nodes that stick, found by `method`.
/// Throws InvalidQuantity for |Q| ≥ μP, which slides.
Friction partial_slip(const Problem& problem, const Solution& solution, double friction_coefficient,
                      double tangential_load, const Method& method);

/// ∂(u_z1 + u_z2)/∂x at the nodes by eq. (2) for both bodies: what the pressure gives, and what the
/// shear adds, (2β/E*) q. In contact the first is −h′ (to order 2 in the spacing for triangles,
/// 1 for the others, whose own slope is infinite), so that the second is what is lost by leaving
/// friction out. Not for one-sided grids, whose mirror image turns a shear round.
struct Slopes {
  Eigen::VectorXd of_pressure;
  Eigen::VectorXd of_shear;
};

/// β: Dundurs' second constant of the two bodies (elasticity::dundurs_beta). Throws InvalidQuantity
/// for a one-sided grid.
Slopes surface_slopes(const Problem& problem, const Solution& solution,
                      const Eigen::VectorXd& shear, double beta);

}  // namespace line_contact
