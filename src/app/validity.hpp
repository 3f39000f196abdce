// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace app {

/// What is left out where half-spaces stand for bodies is of the order of the square of a ratio:
/// from a tenth on it is some per cent, and the user is warned.
inline constexpr double small_ratio = 0.1;

/// A sentence if the contact's half-width is not small beside the bodies' least radius of
/// curvature, 0 where none is known; none if it is.
std::vector<std::string> half_space_warnings(double half_width, double least_radius);

/// Prints each on standard error.
void print_warnings(const std::vector<std::string>& warnings);

}  // namespace app
