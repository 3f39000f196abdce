// SPDX-License-Identifier: GPL-3.0-or-later
#include "elasticity/stress.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <functional>
#include <numbers>

#include "numerics/fourier.hpp"
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

Stress operator*(double factor, const Stress& stress) {
  return {factor * stress.xx, factor * stress.zz, factor * stress.xz};
}

namespace {

using numerics::product;
using Complex = std::complex<double>;

// 1/(t + iz).
Complex reciprocal(double t, double z) {
  const double square = t * t + z * z;
  return {t / square, -z / square};
}

struct Segment {
  double x1, x2;
  double p1, p2;
  double length() const { return x2 - x1; }
};

// F and zF′ of the header.
struct Potentials {
  Complex F;
  Complex depth_dF;
};

void add_near(Potentials& sum, const Segment& s, double x, double z) {
  const double t1 = x - s.x1;
  const double t2 = x - s.x2;
  // (w−x₁)/(w−x₂) has the argument of (w−x₁)·conj(w−x₂)
  const Complex L(std::log((t1 * t1 + z * z) / (t2 * t2 + z * z)) / 2,
                  std::atan2(-z * s.length(), t1 * t2 + z * z));
  const double m = (s.p2 - s.p1) / s.length();
  const Complex p((t1 * s.p2 - t2 * s.p1) / s.length(), m * z);  // p(w)
  sum.F += product(p, L) - (s.p2 - s.p1);
  sum.depth_dF += z * (m * L + s.p1 * reciprocal(t1, z) - s.p2 * reciprocal(t2, z));
}

// The positive abscissae of Gauss's six-point rule on [−1, 1] with their weights (Abramowitz and
// Stegun, table 25.4). At ten half-lengths its error is 20⁻¹².
struct Abscissa {
  double at, weight;
};
constexpr std::array<Abscissa, 3> gauss = {{{0.2386191860831969, 0.4679139345726910},
                                            {0.6612093864662645, 0.3607615730481386},
                                            {0.9324695142031521, 0.1713244923791704}}};

void add_far(Potentials& sum, const Segment& s, double x, double z) {
  const double h = s.length() / 2;
  const double t = x - (s.x1 + h);
  const double mean = (s.p1 + s.p2) / 2;
  const double rise = (s.p2 - s.p1) / 2;
  for (const auto& [at, weight] : gauss) {
    for (const double tau : {-at, at}) {
      const double force = h * weight * (mean + tau * rise);
      const Complex c = reciprocal(t - tau * h, z);
      sum.F += force * c;
      sum.depth_dF -= force * z * product(c, c);
    }
  }
}

bool is_far(const Segment& s, double x, double z) {
  constexpr double half_lengths = 10;
  const double h = s.length() / 2;
  const double t = x - (s.x1 + h);
  return t * t + z * z > half_lengths * half_lengths * h * h;
}

void require_valid(std::span<const double> nodes, std::span<const double> pressures) {
  if (nodes.size() < 2 || nodes.size() != pressures.size()) {
    throw sys::InvalidQuantity("number of nodes", static_cast<double>(nodes.size()),
                               "2 or more, and equal to the number of pressures");
  }
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    sys::require_finite("pressure", pressures[i]);
    sys::require_finite("node", nodes[i]);
    if (i > 0 && !(nodes[i] > nodes[i - 1])) {
      throw sys::InvalidQuantity("node", nodes[i], "greater than the node before it");
    }
  }
}

// Returns p by linear interpolation between the nodes; 0 outside.
double pressure_at(std::span<const double> nodes, std::span<const double> pressures, double x) {
  if (!(x >= nodes.front() && x <= nodes.back())) return 0;
  const auto after = std::upper_bound(nodes.begin(), nodes.end() - 1, x);
  const auto i = static_cast<std::size_t>(after - nodes.begin());
  const double share = (x - nodes[i - 1]) / (nodes[i] - nodes[i - 1]);
  return std::lerp(pressures[i - 1], pressures[i], share);
}

}  // namespace

Stress stress_beneath(std::span<const double> nodes, std::span<const double> pressures, double x,
                      double z) {
  require_valid(nodes, pressures);
  sys::require_finite("x", x);
  if (!(std::isfinite(z) && z >= 0)) {
    throw sys::InvalidQuantity("z", z, "a finite depth, 0 or more");
  }
  if (z == 0) {
    const bool is_at_jump = (x == nodes.front() && pressures.front() != 0) ||
                            (x == nodes.back() && pressures.back() != 0);
    if (is_at_jump) {
      throw sys::InvalidQuantity("x", x, "away from the jump of the pressure on the surface");
    }
    const double p = pressure_at(nodes, pressures, x);
    return {-p, -p, 0};
  }
  Potentials sum;
  for (std::size_t i = 1; i < nodes.size(); ++i) {
    const Segment segment{nodes[i - 1], nodes[i], pressures[i - 1], pressures[i]};
    if (is_far(segment, x, z)) {
      add_far(sum, segment, x, z);
    } else {
      add_near(sum, segment, x, z);
    }
  }
  return std::numbers::inv_pi * Stress{sum.F.imag() + sum.depth_dF.real(),
                                       sum.F.imag() - sum.depth_dF.real(), -sum.depth_dF.imag()};
}

}  // namespace elasticity
