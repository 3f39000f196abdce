// SPDX-License-Identifier: GPL-3.0-or-later
#include "numerics/require.hpp"

#include <fmt/core.h>

#include <cmath>

namespace numerics {

InvalidQuantity::InvalidQuantity(std::string_view quantity, double value, std::string_view allowed)
    : std::invalid_argument(fmt::format("{} = {}: must be {}", quantity, value, allowed)),
      quantity_(quantity),
      allowed_(allowed) {}

double require_finite(std::string_view quantity, double value) {
  if (!std::isfinite(value)) throw InvalidQuantity(quantity, value, "a finite number");
  return value;
}

double require_positive(std::string_view quantity, double value) {
  if (!(std::isfinite(value) && value > 0)) {
    throw InvalidQuantity(quantity, value, "a finite number greater than 0");
  }
  return value;
}

}  // namespace numerics
