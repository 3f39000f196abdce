// SPDX-License-Identifier: GPL-3.0-or-later
// What is learnt from the scatter of observations that have no uncertainty of their own.
#pragma once

#include <string_view>
#include <vector>

#include "numerics/estimate.hpp"
#include "numerics/measured.hpp"

namespace numerics {

/// The mean of n observations with its standard uncertainty s/√n, s² = Σ (yᵢ − ȳ)²/(n − 1)
/// (JCGM 100:2008, the GUM, 4.2.3), in the unit of the observations, and the mean of their bounds.
/// `source` names what makes them scatter. Accuracy: rounding. Throws InvalidQuantity for fewer
/// than two observations.
Measured mean_of(const std::vector<Estimate>& observed, std::string_view source);

/// The power law C·n^−r about which some errors scatter.
struct ScatteredPower {
  Measured order;   ///< r
  Measured factor;  ///< C, in the unit of the errors
};

/// Fits |error| = C·n^−r by linear least squares for the logarithms, all with the same weight.
///
/// The standard uncertainties are those of a straight line (numerics::fit_linear) whose
/// observations have the standard deviation of the residuals, √(Σ residual²/(m − 2)) for m errors.
/// `n` are positive; the errors have any sign, and bounds that are less than themselves; the bounds
/// of order and factor are what these can do. `source` names what makes them scatter. Accuracy:
/// rounding. Throws InvalidQuantity for fewer than three errors, for lists of different lengths and
/// for an error that is not greater than its bound.
ScatteredPower fit_scattered_power(const std::vector<double>& n,
                                   const std::vector<Estimate>& errors, std::string_view source);

}  // namespace numerics
