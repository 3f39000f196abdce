// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "numerics/estimate.hpp"

namespace numerics {

/// The power law C·n^−r that was fitted to some errors, with what the bounds on these may do to it.
struct PowerFit {
  Estimate order;   ///< r
  Estimate factor;  ///< C, in the unit of the errors
};

/// Fits the power law |error| = C·n^−r by linear least squares for the logarithms.
///
/// `n` are positive numbers, such as elements over a half-width, and `errors` has one value for
/// each of them, of any sign, none of them zero. Twenty errors or more are taken in bins of ten as
/// their root mean square, because a single error may happen to be close to zero; an incomplete
/// last bin is left out. Fewer errors are taken one by one. `bounds` says how much each error may
/// be wrong.
///
/// Accuracy: order and factor are the least-squares solution (numerics::fit_linear), their errors
/// bound rounding and what the bounds can do; they do not tell how well a power law describes the
/// errors.
/// Throws sys::InvalidQuantity for fewer than two errors and for lists of different lengths.
PowerFit fit_power(const std::vector<double>& n, const std::vector<double>& errors,
                   const std::vector<double>& bounds = {});

}  // namespace numerics
