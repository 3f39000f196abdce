// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <complex>
#include <span>
#include <vector>

#include "point_contact/elements/lattice.hpp"

namespace point_contact {

/// The potential ∫ B(s)/|d−s| d²s of a box spline B, far from it, by its moments.
///
/// A box spline is a point load smeared uniformly along one vector after another: two vectors make
/// a uniform parallelogram, three a pyramid on a hexagon, each of two twice a bilinear hat. Its
/// volume here is 1. Smearing along e takes f to [sinh(e·∇/2)/(e·∇/2)] f, and so, with
/// Z = ∂x + i∂y, e·∇ = Re(ē Z), and Zᵐ(ZZ̄)ʲ r⁻¹ = (2j−1)!! (2j+2m−1)!! e^{imθ} r^{−1−2j−m},
///
///   V(d) = Σ_k r^{−1−2k} Re Σ_m c_km e^{imθ},   k = 0, 1, …, m = 0, 2, … 2k.
class Multipole {
 public:
  explicit Multipole(std::span<const Vector2> directions);

  /// The greatest distance of the box spline's support from its centre.
  double reach() const { return reach_; }

  /// From here on the expansion is right to rounding.
  double begin() const { return 3 * reach_; }

  /// V(d), the reciprocal of a length, |d| ≥ begin(). Relative accuracy 2e-15.
  double potential(const Vector2& d) const;

 private:
  static constexpr int max_order = 15;  // (1/3)^(2·15) times moments is beneath a rounding
  struct Term {
    int half_m;  // m/2
    std::complex<double> coefficient;
  };
  double reach_ = 0;
  std::vector<std::vector<Term>> orders_;
};

}  // namespace point_contact
