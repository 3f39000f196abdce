// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_contact/cattaneo_mindlin.hpp"

#include <fmt/core.h>

#include <cmath>
#include <numbers>

#include "system/require.hpp"

namespace line_contact {
namespace {

// Returns |Q|/(μP), in which P = π a p₀/2.
double share_of_sliding(const Hertz& normal, double friction, double tangential_load) {
  sys::require_positive("friction", friction);
  sys::require_finite("tangential_load", tangential_load);
  const double limit =
      friction * std::numbers::pi / 2 * normal.half_width() * normal.peak_pressure();
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
      stick_half_width_(normal.half_width() *
                        std::sqrt(1 - share_of_sliding(normal, friction, tangential_load))) {}

double CattaneoMindlin::traction(double x) const {
  const double a = normal_.half_width();
  const double c = stick_half_width_;
  if (std::abs(x) >= c) return std::copysign(friction_, tangential_load_) * normal_.pressure(x);
  const double roots = std::sqrt((a - x) * (a + x)) + std::sqrt((c - x) * (c + x));
  return 2 * tangential_load_ / (std::numbers::pi * roots);
}

}  // namespace line_contact
