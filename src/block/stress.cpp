// SPDX-License-Identifier: GPL-3.0-or-later
#include "block/stress.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace block {

Stress stress(const Lame& lame, const Strain& strain) {
  const double volumetric = lame.lambda * (strain.xx + strain.zz);
  return {volumetric + 2 * lame.mu * strain.xx, volumetric + 2 * lame.mu * strain.zz,
          lame.mu * strain.gamma, volumetric};
}

double von_mises(const Stress& s) {
  const double xz = s.xx - s.zz;
  const double zy = s.zz - s.yy;
  const double yx = s.yy - s.xx;
  return std::sqrt((xz * xz + zy * zy + yx * yx) / 2 + 3 * s.xz * s.xz);
}

std::array<double, 3> principal_stresses(const Stress& s) {
  const double centre = (s.xx + s.zz) / 2;
  const double radius = std::hypot((s.xx - s.zz) / 2, s.xz);
  std::array<double, 3> principal{centre + radius, centre - radius, s.yy};
  std::sort(principal.begin(), principal.end(), std::greater<>());
  return principal;
}

}  // namespace block
