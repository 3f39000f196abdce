// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "literate/figures/plot.hpp"

namespace figures {

/// How far a quadrature is from the closed form, and how far it says it may be; against x/a. NaN
/// for a difference of exactly zero.
struct QuadratureError {
  std::vector<double> x;
  std::vector<double> gradient_difference, gradient_estimate;          ///< in units of K/a
  std::vector<double> displacement_difference, displacement_estimate;  ///< in units of K
};

void draw_quadrature_error(literate::Plot& plot, const QuadratureError& data);

}  // namespace figures
