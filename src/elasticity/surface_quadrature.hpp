// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "elasticity/loads.hpp"
#include "elasticity/material.hpp"
#include "numerics/estimate.hpp"
#include "numerics/kernel_integrals.hpp"

namespace elasticity {

/// The surface of a half-space under any load, by numerical quadrature of eq. (2) and its integral.
///
/// x and datum are lengths; gradients are dimensionless; u_z is positive into the body, u_x in the
/// direction of x. With K = 2(1−ν²)P/(πE) for a load of resultant P on a width 2a, the reported
/// error stays below 1e-10·K/a for gradients and 1e-10·K for displacements if the pieces of the
/// load are smooth; the true error is usually a thousand times smaller. Points may lie at kinks, at
/// the ends of the load, and outside it. Every member throws InvalidQuantity where the result is
/// infinite (a jump of p, a concentrated force) or x is not finite, and QuadratureError where a
/// quadrature fails. Not thread-safe.
class SurfaceQuadrature {
 public:
  /// `datum` is the x at which u_z = 0; it determines the constant C of eq. (3).
  SurfaceQuadrature(const Material& material, const Load& load, double datum);

  /// ∂u_z/∂x = −[2(1−ν²)/(πE)] PV∫ p(s)/(x−s) ds, eq. (2) of the paper.
  numerics::Estimate normal_gradient(double x) const;

  /// u_z(x) = −[2(1−ν²)/(πE)] ∫ p(s) ln|x−s| ds + C: the integral of eq. (2) with the order of
  /// integration exchanged.
  numerics::Estimate normal_displacement(double x) const;

  /// u_z(x) = ∫_datum^x (∂u_z/∂x) dx, with eq. (2) itself integrated numerically at each abscissa:
  /// an independent, slower route to the same number. No concentrated force may lie between datum
  /// and x.
  numerics::Estimate normal_displacement_from_gradient(double x) const;

  /// ∂u_x/∂x by elasticity::tangential_gradient, which needs no quadrature.
  numerics::Estimate tangential_gradient(double x) const;

  /// u_x(x) = −[(1−2ν)(1+ν)/(2E)] [∫_{s<x} p − ∫_{s>x} p], Johnson (2.24a) with q = 0; the two
  /// sides of the load move equally towards it.
  numerics::Estimate tangential_displacement(double x) const;

 private:
  numerics::Estimate displacement_without_constant(double x) const;
  numerics::Estimate integrate_gradient(double begin, double end) const;

  Material material_;
  Load load_;
  double datum_;
  numerics::KernelIntegrals normal_;
  numerics::Estimate constant_;
};

}  // namespace elasticity
