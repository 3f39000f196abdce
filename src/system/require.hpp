// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "system/error.hpp"

namespace sys {

/// A quantity is outside the range that a formula or method allows. what() is the line
/// «quantity = value: must be ALLOWED».
class InvalidQuantity : public InputError {
 public:
  InvalidQuantity(std::string_view quantity, double value, std::string_view allowed);
};

/// Returns `value` if it is a finite number; throws InvalidQuantity otherwise.
double require_finite(std::string_view quantity, double value);

/// Returns `value` if it is finite and > 0; throws InvalidQuantity otherwise.
double require_positive(std::string_view quantity, double value);

}  // namespace sys
