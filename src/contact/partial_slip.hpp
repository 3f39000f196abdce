// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/core.h>

#include <cmath>

#include "system/require.hpp"

namespace contact {

/// How near a tangential load is to sliding: |Q|/(μP), without unit, in [0, 1).
///
/// `load` is P > 0 and `tangential_load` Q, both forces, or both forces per length; `friction` is
/// the coefficient μ > 0. Where |Q| ≥ μP the bodies slide, and no partial slip is left to compute.
/// @throws sys::InvalidQuantity naming the quantity that is outside.
inline double share_of_sliding(double load, double friction, double tangential_load) {
  sys::require_positive("friction", friction);
  sys::require_finite("tangential_load", tangential_load);
  const double limit = friction * load;
  if (!(std::abs(tangential_load) < limit)) {
    throw sys::InvalidQuantity(
        "tangential_load", tangential_load,
        fmt::format("less in magnitude than friction times load, {}: there sliding begins", limit));
  }
  return std::abs(tangential_load) / limit;
}

}  // namespace contact
