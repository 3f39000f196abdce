// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/mcewen.hpp"

#include <fmt/core.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_min.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <new>
#include <stdexcept>

#include "system/require.hpp"

namespace contact {
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

struct FreeMinimizer {
  void operator()(gsl_min_fminimizer* minimizer) const { gsl_min_fminimizer_free(minimizer); }
};

double minus_shear_on_axis(double z, void* mcewen) {
  return -static_cast<const McEwen*>(mcewen)->stress(0, z).max_shear();
}

}  // namespace

McEwen::McEwen(const Hertz& hertz)
    : half_width_(hertz.half_width()), peak_pressure_(hertz.peak_pressure()) {}

// begin excerpt: mcewen
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
// end excerpt: mcewen

GreatestShear McEwen::greatest_shear() const {
  // Bracket the maximum: no shear at z = 0, little at 4a.
  [[maybe_unused]] static gsl_error_handler_t* const former =
      gsl_set_error_handler_off();  // once: not thread-safe
  const std::unique_ptr<gsl_min_fminimizer, FreeMinimizer> minimizer(
      gsl_min_fminimizer_alloc(gsl_min_fminimizer_brent));
  if (!minimizer) throw std::bad_alloc();
  McEwen self = *this;
  gsl_function function{&minus_shear_on_axis, &self};
  int status = gsl_min_fminimizer_set(minimizer.get(), &function, half_width_, 0, 4 * half_width_);

  // Narrow it until the shear no longer tells the ends apart, √ε
  constexpr double depth_tolerance = 1e-7;
  constexpr int max_iterations = 100;
  double low = 0;
  double high = 0;
  for (int i = 0; i < max_iterations && (status == GSL_SUCCESS || status == GSL_CONTINUE); ++i) {
    status = gsl_min_fminimizer_iterate(minimizer.get());
    if (status != GSL_SUCCESS) break;
    low = gsl_min_fminimizer_x_lower(minimizer.get());
    high = gsl_min_fminimizer_x_upper(minimizer.get());
    status = gsl_min_test_interval(low, high, 0, depth_tolerance);
    if (status == GSL_SUCCESS) break;
  }
  if (status != GSL_SUCCESS) {
    throw std::runtime_error(
        fmt::format("greatest shear beneath the contact: {}", gsl_strerror(status)));
  }
  const double depth = gsl_min_fminimizer_x_minimum(minimizer.get());
  // Roundings of some ε in the shear hide the maximum within √(4·5ε/0.85) of the depth, 0.85 being
  // how sharply it is curved.
  const double hidden = 5 * std::sqrt(std::numeric_limits<double>::epsilon()) * depth;
  return {stress(0, depth).max_shear(), {depth, std::max(depth - low, high - depth) + hidden}};
}

}  // namespace contact
