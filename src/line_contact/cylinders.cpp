// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_contact/cylinders.hpp"

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

// Compute the larger root first, which is free of cancellation; their product gives the other.
Roots roots(double x, double z, double a) {
  const double sum = std::hypot(x - a, z) * std::hypot(x + a, z);  // |(x+iz)² − a²|
  const double difference = (a - x) * (a + x) + z * z;
  const double larger = std::sqrt((sum + std::abs(difference)) / 2);
  const double smaller = x * z / larger;
  return difference >= 0 ? Roots{larger, smaller, sum} : Roots{smaller, larger, sum};
}

}  // namespace

Radius Radius::of_cylinder(const char* name, double radius) {
  if (!std::isfinite(radius) || radius == 0) {
    throw sys::InvalidQuantity(name, radius,
                               "a finite number other than 0 (negative for a hollow), or a plane");
  }
  return Radius(1 / radius);
}

CylinderPair::CylinderPair(const elasticity::Material& material1, Radius radius1,
                           const elasticity::Material& material2, Radius radius2)
    : relative_curvature_(radius1.curvature() + radius2.curvature()),
      contact_modulus_(elasticity::contact_modulus(material1, material2)) {
  if (!(relative_curvature_ > 0)) {
    throw sys::InvalidQuantity("1/radius1 + 1/radius2", relative_curvature_,
                               "greater than 0: at most one plane, and a hollow only if wider than "
                               "the cylinder in it");
  }
}

Hertz::Hertz(const CylinderPair& cylinders, double line_load)
    : relative_curvature_(cylinders.relative_curvature()),
      half_width_(std::sqrt(
          4 * sys::require_positive("load", line_load) /
          (std::numbers::pi * cylinders.contact_modulus() * cylinders.relative_curvature()))),
      peak_pressure_(2 * line_load / (std::numbers::pi * half_width_)) {}

double Hertz::pressure(double x) const {
  // Near the edge a − |x| is exact, while 1 − (x/a)² loses digits.
  const double from_edge = half_width_ - std::abs(x);
  if (from_edge <= 0) return 0;
  return peak_pressure_ / half_width_ * std::sqrt(from_edge * (half_width_ + std::abs(x)));
}

double Hertz::approach(double datum) const {
  const double xi = std::abs(sys::require_finite("datum", datum)) / half_width_;
  const double scale = half_width_ * half_width_ * relative_curvature_ / 2;
  if (xi <= 1) return scale * xi * xi;
  return scale * (xi / (xi + std::sqrt((xi - 1) * (xi + 1))) + std::acosh(xi));
}

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

}  // namespace line_contact
