// SPDX-License-Identifier: GPL-3.0-or-later
#include "elasticity/stress.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "system/require.hpp"

namespace elasticity {
namespace {

double checked(double nu) {
  if (!(nu > -1 && nu <= 0.5)) {
    throw sys::InvalidQuantity("poisson", nu, "greater than -1 and at most 1/2");
  }
  return nu;
}

}  // namespace

Stress& Stress::operator+=(const Stress& other) {
  xx += other.xx;
  zz += other.zz;
  xz += other.xz;
  return *this;
}

double Stress::yy(double nu) const {
  return checked(nu) * (xx + zz);
}

double Stress::max_shear() const {
  return std::hypot((xx - zz) / 2, xz);
}

std::array<double, 3> Stress::principal(double nu) const {
  const double mean = (xx + zz) / 2;
  const double shear = max_shear();
  std::array<double, 3> stresses{mean + shear, mean - shear, yy(nu)};
  std::ranges::sort(stresses, std::greater<>());
  return stresses;
}

double Stress::largest_shear(double nu) const {
  const auto stresses = principal(nu);
  return (stresses.front() - stresses.back()) / 2;
}

double Stress::von_mises(double nu) const {
  return std::hypot(std::numbers::sqrt3 * max_shear(), (1 - 2 * checked(nu)) * (xx + zz) / 2);
}

Stress operator+(Stress a, const Stress& b) {
  return a += b;
}

Stress operator*(double factor, const Stress& stress) {
  return {factor * stress.xx, factor * stress.zz, factor * stress.xz};
}

}  // namespace elasticity
