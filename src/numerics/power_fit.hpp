// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "numerics/estimate.hpp"

namespace numerics {

/// The power law C·n^−r that was fitted to some errors.
struct PowerFit {
  double order;         ///< r
  double factor;        ///< C, in the unit of the errors
  double order_error;   ///< how much r may be wrong because the errors are known with errors
  double factor_error;  ///< the same of C

  Estimate order_estimate() const { return {order, order_error}; }
  Estimate factor_estimate() const { return {factor, factor_error}; }
};

/// Fits the power law |error| = C·n^−r by linear least squares for the logarithms.
///
/// `n` are positive numbers, such as elements over a half-width, and `errors` has one value for
/// each of them, of any sign, none of them zero. Twenty errors or more are taken in bins of ten as
/// their root mean square, because a single error may happen to be close to zero; an incomplete
/// last bin is left out. Fewer errors are taken one by one. `bounds` says how much each error may
/// be wrong; without it order_error and factor_error are 0.
///
/// Accuracy: order and factor are the least-squares solution to rounding. order_error
/// and factor_error bound what the bounds can do to them; they do not tell how well a power law
/// describes the errors.
/// Throws sys::InvalidQuantity for fewer than two errors and for lists of different lengths.
PowerFit fit_power(const std::vector<double>& n, const std::vector<double>& errors,
                   const std::vector<double>& bounds = {});

}  // namespace numerics
