// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_contact/power_law.hpp"

#include <fmt/core.h>

#include <cmath>
#include <numbers>

#include "system/require.hpp"

namespace line_contact {
namespace {

// c_k/c_{k−1} with c_k = (2k−1)!!/(2k)!!.
double ratio(int k) {
  return (2 * k - 1) / (2.0 * k);
}

double checked_coefficient(int n) {
  if (n < 1 || n > Profile::max_power) {
    throw sys::InvalidQuantity("n", n, fmt::format("from 1 to {}", Profile::max_power));
  }
  double c = 1;
  for (int k = 1; k <= n; ++k) c *= ratio(k);
  return c;
}

// s(z) = Σ_{k<n} c_k z^{n−1−k} and its derivative, by Horner's rule.
struct Polynomial {
  double value = 0;
  double derivative = 0;
};
Polynomial polynomial(int n, double z) {
  Polynomial s;
  double c = 1;
  for (int k = 0; k < n; ++k) {
    if (k > 0) c *= ratio(k);
    s.derivative = s.derivative * z + s.value;
    s.value = s.value * z + c;
  }
  return s;
}

// sinh y − y for y ≥ 0. Beyond y = 1 the difference loses less than a digit; below it, nine terms
// of the series reach rounding.
double sinh_minus_argument(double y) {
  if (y > 1) return std::sinh(y) - y;
  double term = y * y * y / 6;
  double sum = term;
  for (int k = 2; k < 10; ++k) sum += term *= y * y / (2 * k * (2 * k + 1));
  return sum;
}

}  // namespace

PowerLaw::PowerLaw(double contact_modulus, double coefficient, int n, double line_load)
    : contact_modulus_(sys::require_positive("contact_modulus", contact_modulus)),
      line_load_(sys::require_positive("load", line_load)),
      n_(n),
      load_coefficient_(checked_coefficient(n)),
      half_width_(std::pow(
          line_load / (std::numbers::pi * contact_modulus * n *
                       sys::require_positive("coefficient", coefficient) * load_coefficient_),
          0.5 / n)) {}

double PowerLaw::coefficient_for(double contact_modulus, int n, double half_width,
                                 double line_load) {
  return sys::require_positive("load", line_load) /
         (std::numbers::pi * sys::require_positive("contact_modulus", contact_modulus) * n *
          checked_coefficient(n) *
          std::pow(sys::require_positive("half_width", half_width), 2 * n));
}

double PowerLaw::peak_pressure() const {
  // With z = ξ², p' has the sign of 2(1−z)s' − s: one sign change among its coefficients, one root,
  // where p is flat, so that bisection to 1e-9 gives all digits of p.
  double low = 0;
  double high = 1;
  while (high - low > 1e-9) {
    const double z = (low + high) / 2;
    const Polynomial s = polynomial(n_, z);
    (2 * (1 - z) * s.derivative > s.value ? low : high) = z;
  }
  return pressure(half_width_ * std::sqrt(low));
}

double PowerLaw::pressure(double x) const {
  const double xi = std::abs(x) / half_width_;
  if (xi >= 1) return 0;
  const double root = std::sqrt((half_width_ - x) * (half_width_ + x)) / half_width_;
  return line_load_ / (std::numbers::pi * load_coefficient_ * half_width_) * root *
         polynomial(n_, xi * xi).value;
}

double PowerLaw::gap(double x) const {
  const double xi = std::abs(x) / half_width_;
  if (xi <= 1) return 0;
  const double root =
      std::sqrt((std::abs(x) - half_width_) * (std::abs(x) + half_width_)) / half_width_;

  // I_m for m = 0 … n−1 against c_{n−1−m}
  double integral = sinh_minus_argument(2 * std::asinh(root)) / 4;
  double c = load_coefficient_ / ratio(n_);
  double sum = c * integral;
  double power = root * root * root * xi;
  for (int m = 1; m < n_; ++m) {
    integral = (power + (2 * m - 1) * integral) / (2 * m + 2);
    power *= xi * xi;
    c /= ratio(n_ - m);
    sum += c * integral;
  }
  return 2 * line_load_ / (std::numbers::pi * contact_modulus_ * load_coefficient_) * sum;
}

}  // namespace line_contact
