// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_contact/cylinder_friction.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "contact/partial_slip.hpp"
#include "line_contact/cylinders.hpp"
#include "system/require.hpp"

namespace line_contact {
namespace {

// P = π a p₀/2
double load_of(const Hertz& normal) {
  return std::numbers::pi / 2 * normal.half_width() * normal.peak_pressure();
}

}  // namespace

CattaneoMindlin::CattaneoMindlin(const Hertz& normal, double friction, double tangential_load)
    : normal_(normal),
      friction_(friction),
      tangential_load_(tangential_load),
      stick_half_width_(
          normal.half_width() *
          std::sqrt(1 - contact::share_of_sliding(load_of(normal), friction, tangential_load))) {}

double CattaneoMindlin::traction(double x) const {
  const double a = normal_.half_width();
  const double c = stick_half_width_;
  if (std::abs(x) >= c) return std::copysign(friction_, tangential_load_) * normal_.pressure(x);
  const double roots = std::sqrt((a - x) * (a + x)) + std::sqrt((c - x) * (c + x));
  return 2 * tangential_load_ / (std::numbers::pi * roots);
}

SlidingHertz::SlidingHertz(const Hertz& hertz, double friction)
    : half_width_(hertz.half_width()),
      peak_pressure_(hertz.peak_pressure()),
      friction_(sys::require_finite("friction", friction)) {}

elasticity::Stress SlidingHertz::stress(double x, double z) const {
  sys::require_finite("x", x);
  sys::require_positive("z", z);
  const double a = half_width_;
  const double p = peak_pressure_;
  const double mu = friction_;
  const std::complex<double> w(x, z);
  const std::complex<double> root = std::sqrt(w - a) * std::sqrt(w + a);
  const std::complex<double> f = p / a * (w - root);             // F/π
  const std::complex<double> zf = z * p / a * (1.0 - w / root);  // zF′/π
  return {f.imag() + zf.real() - 2 * mu * f.real() + mu * zf.imag(),
          f.imag() - zf.real() - mu * zf.imag(), -zf.imag() + mu * (f.imag() + zf.real())};
}

CoupledSliding::CoupledSliding(const CylinderPair& cylinders, double line_load, double friction,
                               double dundurs_beta)
    : gamma_(-std::atan(sys::require_finite("dundurs_beta", dundurs_beta) *
                        sys::require_finite("friction", friction)) /
             std::numbers::pi),
      half_width_(Hertz(cylinders, line_load).half_width() / std::sqrt(1 - 4 * gamma_ * gamma_)),
      shift_(2 * gamma_ * half_width_),
      factor_(cylinders.contact_modulus() * cylinders.relative_curvature() / 2 *
              std::cos(std::numbers::pi * gamma_)) {}

double CoupledSliding::pressure(double x) const {
  const double t = std::clamp(x - shift_, -half_width_, half_width_);
  return factor_ * std::pow(half_width_ + t, 0.5 + gamma_) *
         std::pow(half_width_ - t, 0.5 - gamma_);
}

}  // namespace line_contact
