// SPDX-License-Identifier: GPL-3.0-or-later
// Pressures on |x| ≤ a with closed forms. (The paper's triangle and the concentrated force have
// separate files.)
#pragma once

#include "elasticity/load.hpp"
#include "elasticity/material.hpp"

namespace elasticity {

/// The uniform pressure p(x) = p₀ for |x| ≤ a, a strip load.
class UniformLoad : public PeakedLoad {
 public:
  using PeakedLoad::PeakedLoad;

  /// The resultant 2p₀a, force per unit length.
  double line_load() const { return 2 * peak_pressure() * half_width(); }

  operator Load() const;  // NOLINT(google-explicit-constructor): a uniform load is a load
};

/// ∂u_z/∂x = −[2(1−ν²)p₀/(πE)] ln|(x + a)/(x − a)| under a uniform load (eq. 2; Johnson, section
/// 2.5, derived).
///
/// Dimensionless. Throws InvalidQuantity at x = ±a, where the gradient is infinite because of the
/// step in traction for which the paper rejects uniform elements. Accuracy: 1e-14 relative.
double normal_gradient(const Material& material, const UniformLoad& load, double x);

/// u_z = −(1−ν²)p₀/(πE) [(x+a) ln((x+a)/a)² − (x−a) ln((x−a)/a)²] + C with u_z(datum) = 0 (Johnson,
/// section 2.5). A length, positive into the body; any finite x and datum.
///
/// Accuracy: 1e-14·K·(1 + ln(datum/a)) absolute, K = 4(1−ν²)p₀a/(πE).
double normal_displacement(const Material& material, const UniformLoad& load, double x,
                           double datum);

/// u_x = −[(1−2ν)(1+ν)/E] p₀ x under the load; outside it keeps its value at the edge. Johnson
/// (2.24a) with q = 0. A length, positive along x; any finite x.
double tangential_displacement(const Material& material, const UniformLoad& load, double x);

/// p(x) = p₀·[1 − (1 − e)|x|/a]: a pressure that falls linearly from its peak in the middle to the
/// fraction e of it at the edges. e = 0 gives the triangle of eq. (4), e = 1 a uniform load.
class LinearFall : public PeakedLoad {
 public:
  /// Throws InvalidQuantity unless p₀ (stress) and a (length) are > 0 and e ≥ 0.
  LinearFall(double peak_pressure, double edge_fraction, double half_width);

  double edge_fraction() const { return edge_fraction_; }

  /// The resultant (1 + e) p₀a, force per unit length.
  double line_load() const { return (1 + edge_fraction_) * peak_pressure() * half_width(); }

  operator Load() const;  // NOLINT(google-explicit-constructor): a linear fall is a load

 private:
  double edge_fraction_;
};

/// Displacements and gradients under a linear fall: (1 − e) times those of the triangle plus e
/// times those of the uniform load, with their units, domains and accuracy. The gradient is
/// infinite at x = ±a unless e = 0.
double normal_gradient(const Material& material, const LinearFall& load, double x);
double normal_displacement(const Material& material, const LinearFall& load, double x,
                           double datum);
double tangential_displacement(const Material& material, const LinearFall& load, double x);

}  // namespace elasticity
