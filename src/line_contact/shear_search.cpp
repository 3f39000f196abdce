// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_contact/shear_search.hpp"

#include <algorithm>

#include "system/require.hpp"

namespace line_contact {

ShearPoint find_greatest_shear(const std::function<elasticity::Stress(double x, double z)>& stress,
                               double half_width, double least_depth) {
  const double a = sys::require_positive("half_width", half_width);
  sys::require_positive("least_depth", least_depth);
  constexpr int n_steps = 10;   // the steps on either side of the centre
  constexpr int n_rounds = 11;  // each round has steps a quarter as long as the last, so that the
                                // steps end at 0.12 a/4¹⁰ = 1e-7 a
  ShearPoint best{0, 0.8 * a, 0};
  double half_x = 1.2 * a;
  double half_z = 0.8 * a;
  for (int round = 0; round < n_rounds; ++round) {
    const ShearPoint centre = best;
    for (int i = -n_steps; i <= n_steps; ++i) {
      for (int k = -n_steps; k <= n_steps; ++k) {
        const double x = centre.x + half_x * i / n_steps;
        const double z = std::max(centre.z + half_z * k / n_steps, least_depth);
        const double shear = stress(x, z).max_shear();
        if (shear > best.shear) best = {x, z, shear};
      }
    }
    half_x /= 4;
    half_z /= 4;
  }
  return best;
}

}  // namespace line_contact
