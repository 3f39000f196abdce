// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/closed_forms/cattaneo_mindlin.hpp"

#include <fmt/core.h>

#include <cmath>

#include "system/require.hpp"

namespace point_contact {
namespace {

// |Q|/(μP)
double share_of_sliding(const Hertz& normal, double friction, double tangential_load) {
  sys::require_positive("friction", friction);
  sys::require_finite("tangential_load", tangential_load);
  const double limit = friction * normal.load();
  if (!(std::abs(tangential_load) < limit)) {
    throw sys::InvalidQuantity(
        "tangential_load", tangential_load,
        fmt::format("less in magnitude than friction times load, {}: there sliding begins", limit));
  }
  return std::abs(tangential_load) / limit;
}

}  // namespace

CattaneoMindlin::CattaneoMindlin(const Hertz& normal, double friction, double tangential_load)
    : normal_(normal),
      friction_(friction),
      tangential_load_(tangential_load),
      share_of_sliding_(share_of_sliding(normal, friction, tangential_load)),
      stick_radius_(normal.radius() * std::cbrt(1 - share_of_sliding_)) {}

double CattaneoMindlin::traction(double r) const {
  const double a = normal_.radius();
  const double c = stick_radius_;
  const double distance = std::abs(r);
  const double sign = std::copysign(1, tangential_load_);
  if (distance >= c) return share_of_sliding_ == 0 ? 0 : sign * friction_ * normal_.pressure(r);
  // a² − c² = a² [1 − (1−s)^{2/3}], s the share of sliding, which keeps a small load's digits
  const double ring = -a * a * std::expm1(2. / 3 * std::log1p(-share_of_sliding_));
  const double roots =
      std::sqrt((a - distance) * (a + distance)) + std::sqrt((c - distance) * (c + distance));
  return sign * friction_ * normal_.peak_pressure() / a * ring / roots;
}

double CattaneoMindlin::displacement(double tangential_compliance) const {
  sys::require_positive("tangential_compliance", tangential_compliance);
  const double bracket = -std::expm1(2. / 3 * std::log1p(-share_of_sliding_));
  return std::copysign(3 * friction_ * normal_.load() / (16 * normal_.radius()), tangential_load_) *
         tangential_compliance * bracket;
}

}  // namespace point_contact
