// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/require.hpp"

#include <fmt/core.h>

#include <cmath>

namespace sys {

InvalidQuantity::InvalidQuantity(std::string_view quantity, double value, std::string_view allowed)
    : InputError(fmt::format("{} = {}: must be {}", quantity, value, allowed)) {}

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

}  // namespace sys
