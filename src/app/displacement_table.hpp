// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/result.hpp"
#include "config/units.hpp"
#include "numerics/estimate.hpp"

namespace app {

/// A number at one point both ways: eq. (2) by quadrature, and in closed form, where there is one.
struct BothWays {
  numerics::Estimate quadrature = {};
  std::optional<double> closed_form = {};
};

struct DisplacementRow {
  double x;
  BothWays gradient = {};
  BothWays displacement = {};
  long n_evaluations = 0;  ///< of the load, for both quadratures
};

/// What is said below a table.
struct DisplacementNotes {
  std::string closed_form;  ///< what stands beside the quadratures; empty if nothing does
  double seconds;           ///< that the quadratures took
};

/// |quadrature − closed form| over the error: the quadrature's estimate and four roundings of the
/// closed form. 0 where there is no closed form.
double difference_over_error(const BothWays& number);

/// A row a point, without columns of closed forms if there are none; for people 13 significant
/// digits, the difference over the error and the evaluations of the load, and below the table what
/// stands beside what, how many points agree within their errors, evaluations and time.
Result displacement_result(const std::vector<DisplacementRow>& rows,
                           const config::UnitSystem& units, const DisplacementNotes& notes);

}  // namespace app
