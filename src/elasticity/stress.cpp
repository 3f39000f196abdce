// SPDX-License-Identifier: GPL-3.0-or-later
#include "elasticity/stress.hpp"

#include <cmath>
#include <numbers>

#include "system/require.hpp"

namespace elasticity {

Stress& Stress::operator+=(const Stress& other) {
  xx += other.xx;
  zz += other.zz;
  xz += other.xz;
  return *this;
}

double Stress::max_shear() const {
  return std::hypot((xx - zz) / 2, xz);
}

PrincipalStresses Stress::principal() const {
  const double mean = (xx + zz) / 2;
  const double shear = max_shear();
  return {mean + shear, mean - shear};
}

double Stress::von_mises(double nu) const {
  if (!(nu > -1 && nu <= 0.5)) {
    throw sys::InvalidQuantity("poisson", nu, "greater than -1 and at most 1/2");
  }
  return std::hypot(std::numbers::sqrt3 * max_shear(), (1 - 2 * nu) * (xx + zz) / 2);
}

Stress operator+(Stress a, const Stress& b) {
  return a += b;
}

Stress operator*(double factor, const Stress& stress) {
  return {factor * stress.xx, factor * stress.zz, factor * stress.xz};
}

}  // namespace elasticity
