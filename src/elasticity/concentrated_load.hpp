// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "elasticity/load.hpp"
#include "elasticity/material.hpp"
#include "elasticity/stress.hpp"

namespace elasticity {

/// A concentrated normal force P per unit length at x = 0.
class ConcentratedLoad {
 public:
  /// line_load P > 0 (force per unit length), or InvalidQuantity is thrown.
  explicit ConcentratedLoad(double line_load);

  double line_load() const { return line_load_; }

  operator Load() const;  // NOLINT(google-explicit-constructor): a concentrated load is a load

 private:
  double line_load_;
};

/// ∂u_z/∂x = −2(1−ν²)P/(πE x) under a concentrated force (Johnson, section 2.2).
///
/// Dimensionless. Throws InvalidQuantity at x = 0, where it is infinite.
double normal_gradient(const Material& material, const ConcentratedLoad& load, double x);

/// u_z = −2(1−ν²)P/(πE) ln|x/datum| (Johnson, section 2.2). A length, positive into the body.
///
/// Throws InvalidQuantity at x = 0 and for a datum of 0, where the displacement is infinite.
double normal_displacement(const Material& material, const ConcentratedLoad& load, double x,
                           double datum);

/// The stress at (x, z), z ≥ 0 into the body, tension positive (Flamant; Johnson 2.23):
///
///   σ_xx = −(2P/π) x²z/r⁴,  σ_zz = −(2P/π) z³/r⁴,  σ_xz = −(2P/π) xz²/r⁴,  r² = x² + z².
///
/// Accuracy: a few roundings, relative; fourth powers of lengths must neither overflow nor
/// underflow. Throws InvalidQuantity for x or z that is not finite, for z < 0 and at the force.
Stress stress_under(const ConcentratedLoad& load, double x, double z);

}  // namespace elasticity
