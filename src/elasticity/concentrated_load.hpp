// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "elasticity/load.hpp"
#include "elasticity/material.hpp"

namespace elasticity {

/// A concentrated normal force P per unit length at x = 0.
class ConcentratedLoad {
 public:
  /// line_load P (force per unit length). Throws InvalidQuantity unless P > 0.
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

}  // namespace elasticity
