// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "point_contact/closed_forms/hertz.hpp"

namespace point_contact {

/// Stresses in cylindrical coordinates r, θ, z about the axis of a point contact; tension positive,
/// z into the body, σ_zz = −p on the surface.
struct AxialStress {
  double rr;
  double tt;
  double zz;
  double rz;
};

/// The stresses in a body under Hertz's pressure of spheres: Huber (1904), Ann. Phys. 319, 153;
/// Johnson 3.45 on the axis, §3.4 on the surface.
///
/// With u the greater root of r²/(a²+u) + z²/u = 1 and w = z/√u, both free of cancellation:
///
///   σ_zz/p₀ = −w³ a²/(u + a²w²)
///   σ_rr/p₀ =  (1−2ν)/3 S + w³ a²/(u + a²w²) + w [(1−ν)u/(a²+u) + (1+ν)(√u/a) arctan(a/√u) − 2]
///   σ_θθ/p₀ = −(1−2ν)/3 S − w [2ν + (1−ν)u/(a²+u) − (1+ν)(√u/a) arctan(a/√u)]
///   σ_rz/p₀ = −r w² a² √u/[(u + a²w²)(a²+u)],   S = (a²/r²)(1 − w³) = a²(1+w+w²)/[(1+w)(a²+u)]
class Huber {
 public:
  /// nu is Poisson's ratio of the body, −1 < ν ≤ 1/2, or InvalidQuantity is thrown.
  Huber(const Hertz& normal, double nu);

  /// At r and depth z ≥ 0, lengths (InvalidQuantity for z < 0). Accuracy: 1e-15 p₀. At the
  /// contact's edge on the surface the limits along the surface are returned.
  AxialStress stress(double r, double z) const;

 private:
  Hertz normal_;
  double nu_;
};

}  // namespace point_contact
