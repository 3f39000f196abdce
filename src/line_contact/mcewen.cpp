// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_contact/mcewen.hpp"

#include <cmath>
#include <numbers>

#include "system/require.hpp"

namespace line_contact {
namespace {

// The roots m, n ≥ 0 of m² − n² = a² − x² + z², mn = xz for x ≥ 0, and m² + n².
struct Roots {
  double m;
  double n;
  double sum_of_squares;
};

// Take the larger root first, which does not cancel; their product gives the other.
Roots roots(double x, double z, double a) {
  const double sum = std::hypot(x - a, z) * std::hypot(x + a, z);  // |(x+iz)² − a²|
  const double difference = (a - x) * (a + x) + z * z;
  const double larger = std::sqrt((sum + std::abs(difference)) / 2);
  const double smaller = x * z / larger;
  return difference >= 0 ? Roots{larger, smaller, sum} : Roots{smaller, larger, sum};
}

}  // namespace

McEwen::McEwen(const Hertz& hertz)
    : half_width_(hertz.half_width()), peak_pressure_(hertz.peak_pressure()) {}

// With c = a(z+m)/[(|x|+n)² + (z+m)²], m − z = ac and Johnson's differences become
//   m² − z² = ac(z+m),  2(m²+n²) − m(z+m) = 2n² + acm.
elasticity::Stress McEwen::stress(double x, double z) const {
  sys::require_finite("x", x);
  if (!(std::isfinite(z) && z >= 0)) {
    throw sys::InvalidQuantity("z", z, "a finite depth, 0 or more");
  }
  const double a = half_width_;
  const auto [m, n, sum_of_squares] = roots(std::abs(x), z, a);
  if (sum_of_squares == 0) return {};  // at an edge, where n is 0/0

  const double across = std::abs(x) + n;
  const double c = a * (z + m) / (across * across + (z + m) * (z + m));
  const double factor = -peak_pressure_ * c / sum_of_squares;
  const double xz = factor * n * (z + m);
  return {factor * (2 * n * n + a * c * m), factor * m * (z + m), x < 0 ? -xz : xz};
}

// With s = z/√(a² + z²) the shear on the axis is p₀ (z/a)(1 − s), greatest where s² + s = 1.
GreatestShear McEwen::greatest_shear() const {
  constexpr double phi = std::numbers::phi;
  return {peak_pressure_ / (phi * phi * std::sqrt(phi)), half_width_ / std::sqrt(phi)};
}

}  // namespace line_contact
