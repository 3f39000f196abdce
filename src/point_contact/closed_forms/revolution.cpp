// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/closed_forms/revolution.hpp"

#include <fmt/core.h>

#include <cmath>
#include <numbers>

#include "point_contact/bodies/profile.hpp"
#include "system/require.hpp"

namespace point_contact {
namespace {

double checked_factor(int n) {
  if (n < 1 || n > Profile::max_power) {
    throw sys::InvalidQuantity("n", n, fmt::format("from 1 to {}", Profile::max_power));
  }
  double factor = 1;
  for (int k = 1; k <= n; ++k) factor *= 2.0 * k / (2 * k - 1);
  return factor;
}

}  // namespace

double excess_over_arctangent(double w) {
  // Beyond 0.6 the subtraction loses less than four bits; below, 40 terms of the series
  // w³/3 − w⁵/5 + … reach rounding.
  constexpr double near = 0.6;
  if (w > near) return w - std::atan(w);
  constexpr int n_terms = 40;
  double sum = 0;
  for (int k = n_terms; k >= 1; --k) sum = 1.0 / (2 * k + 1) - w * w * sum;
  return w * w * w * sum;
}

FlatPunch::FlatPunch(double contact_modulus, double radius, double load)
    : radius_(sys::require_positive("radius", radius)),
      load_(sys::require_positive("load", load)),
      approach_(load / (2 * radius * sys::require_positive("contact_modulus", contact_modulus))) {}

double FlatPunch::pressure(double r) const {
  const double distance = std::abs(r);
  if (distance > radius_) return 0;
  const double root = std::sqrt((radius_ - distance) * (radius_ + distance));
  return load_ / (2 * std::numbers::pi * radius_ * root);
}

double FlatPunch::displacement(double r) const {
  const double distance = std::abs(r);
  if (distance <= radius_) return approach_;
  return 2 * approach_ / std::numbers::pi * std::asin(radius_ / distance);
}

Cone::Cone(double contact_modulus, double slope, double load)
    : contact_modulus_(sys::require_positive("contact_modulus", contact_modulus)),
      slope_(sys::require_positive("slope", slope)),
      radius_(std::sqrt(2 * sys::require_positive("load", load) /
                        (std::numbers::pi * contact_modulus * slope))) {}

double Cone::approach() const {
  return std::numbers::pi / 2 * radius_ * slope_;
}

double Cone::pressure(double r) const {
  const double distance = std::abs(r);
  if (distance >= radius_) return 0;
  // arcosh(a/r) = arsinh(√(a²−r²)/r), which keeps its digits at the edge
  const double root = std::sqrt((radius_ - distance) * (radius_ + distance));
  return contact_modulus_ * slope_ / 2 * std::asinh(root / distance);
}

double Cone::gap(double r) const {
  const double distance = std::abs(r);
  if (distance <= radius_) return 0;
  const double tangent = std::sqrt((distance - radius_) * (distance + radius_)) / radius_;
  return radius_ * slope_ * excess_over_arctangent(tangent);
}

PowerLaw::PowerLaw(double contact_modulus, double coefficient, int n, double load)
    : contact_modulus_(sys::require_positive("contact_modulus", contact_modulus)),
      coefficient_(sys::require_positive("coefficient", coefficient)),
      n_(n),
      factor_(checked_factor(n)),
      radius_(std::pow((2 * n + 1) * sys::require_positive("load", load) /
                           (4 * n * factor_ * coefficient * contact_modulus),
                       1.0 / (2 * n + 1))) {}

double PowerLaw::approach() const {
  return factor_ * coefficient_ * std::pow(radius_, 2 * n_);
}

double PowerLaw::pressure(double r) const {
  const double distance = std::abs(r);
  if (distance >= radius_) return 0;
  const double t = std::sqrt((radius_ - distance) * (radius_ + distance)) / radius_;
  const double square = distance * distance / (radius_ * radius_);
  double sum = 0;
  double binomial = 1;
  for (int k = 0; k < n_; ++k) {
    sum += binomial * std::pow(square, n_ - 1 - k) * std::pow(t, 2 * k + 1) / (2 * k + 1);
    binomial *= static_cast<double>(n_ - 1 - k) / (k + 1);
  }
  return 2 * n_ * factor_ * coefficient_ * contact_modulus_ / std::numbers::pi *
         std::pow(radius_, 2 * n_ - 1) * sum;
}

}  // namespace point_contact
