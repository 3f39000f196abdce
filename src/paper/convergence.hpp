// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "contact/hertz.hpp"
#include "contact/solution.hpp"
#include "numerics/estimate.hpp"
#include "parameters/case.hpp"

namespace paper {

/// How far a solution for two cylinders is from Hertz; relative, or over p₀.
struct HertzErrors {
  double elements;                 ///< a/c
  double inside;                   ///< root mean square of p over |x| ≤ 0.9 a
  double largest;                  ///< of p at the nodes
  double peak;                     ///< of the greatest pressure, with its sign
  double half_width_count;         ///< half-width by the nodes in contact
  double half_width_extrapolated;  ///< by p² extrapolated to zero
  double half_width_moment;        ///< by the second moment
};

/// The domain of these studies, in half-widths of Hertz.
inline constexpr double cylinder_domain = 2.2;

/// The case's cylinders solved on n_nodes over this domain.
contact::Solution solve_cylinders(const parameters::ContactCase& c, const contact::Hertz& hertz,
                                  contact::Element element, long n_nodes);

HertzErrors errors_against(const contact::Hertz& hertz, const contact::Solution& solution);

/// The errors on a number of grids from 15 to 750 elements over the half-width, so many that the
/// edge of the contact falls everywhere between nodes.
struct ConvergenceStudy {
  std::vector<double> elements, inside, largest, peak, count, extrapolated, moment;
};
ConvergenceStudy convergence_study(const parameters::ContactCase& c, const contact::Hertz& hertz,
                                   contact::Element element);

/// Errors C·n^−r.
struct Power {
  double order;        ///< r
  double factor;       ///< C
  double order_error;  ///< how wrong r may be, since the errors are known with errors

  numerics::Estimate order_estimate() const { return {order, order_error}; }
};

/// r and C by least squares for the logarithms, the errors taken in bins of ten as their root mean
/// square (a single one may happen to be next to nothing); fewer than twenty are taken one by one.
///
/// `bounds` says how wrong each of the errors may be, in their order; without it order_error is 0.
Power fitted_power(const std::vector<double>& n, const std::vector<double>& errors,
                   const std::vector<double>& bounds = {});

}  // namespace paper
