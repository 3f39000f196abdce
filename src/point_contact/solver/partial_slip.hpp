// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "elasticity/material.hpp"
#include "point_contact/solver/methods.hpp"

namespace point_contact {

/// What friction adds to a contact whose pressure is known: the shear traction along x, uncoupled,
/// which means that its effect on the pressure is neglected (none for β = 0), and so is what it
/// does across itself (none for ν = 0).
struct Friction {
  Eigen::VectorXd shear;      ///< q at the nodes, a stress, positive along x on body 1
  double tangential_load;     ///< Q, a force
  double stick_load;          ///< what the contact would carry whose pressure is taken away
  Eigen::Index n_sticking;    ///< nodes that stick; 0 if the bodies slide
  double stick_approach = 0;  ///< δ under stick_load
};

/// Sliding: q = μp everywhere, Q = μP. Throws InvalidQuantity unless μ is finite and ≥ 0.
Friction sliding(const Solution& solution, double friction_coefficient);

/// Partial slip under a tangential load |Q| < μP that follows the normal one: the theorem of
/// Ciavarella and Jäger, q = ±μ[p(P) − p(P − |Q|/μ)], for alike materials and any profile (Jäger
/// 1998, Arch. Appl. Mech. 68, 551; for spheres that of Cattaneo and Mindlin, Johnson §7.2). The
/// second pressure is that of the nodes that stick. Throws InvalidQuantity for |Q| ≥ μP, which
/// slides, and what solve_for_load() throws.
Friction partial_slip(const Problem& problem, const Solution& solution, double friction_coefficient,
                      double tangential_load, const Accuracy& accuracy = {});

/// C = (2−ν₁)/G₁ + (2−ν₂)/G₂, the reciprocal of a stress (Johnson 7.43).
double tangential_compliance(const elasticity::Material& first, const elasticity::Material& second);

/// The displacement of distant points along x under partial slip, a length with the sign of Q, for
/// bodies of revolution:
///
///   δ_x = ¼ μ E* C (δ − δ*),  δ* under the stick load,
///
/// since each flat punch that such a contact is made of moves by C/8a under a force along x where
/// it sinks by 1/(2aE*) under the same along z (Jäger 1998; for spheres Johnson 7.43).
double tangential_displacement(const Problem& problem, const Solution& solution,
                               const Friction& friction, double friction_coefficient,
                               double compliance);

}  // namespace point_contact
