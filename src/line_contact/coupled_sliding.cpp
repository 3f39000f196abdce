// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_contact/coupled_sliding.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "line_contact/hertz.hpp"
#include "system/require.hpp"

namespace line_contact {

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
