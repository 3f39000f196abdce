// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "assignment/exercises/quadrature_checks.hpp"
#include "assignment/hidden/reference.hpp"

namespace assignment::quadrature {
namespace {

// The greatest slope at 81 places under and beside the load, which is within 1 % of the maximum.
double greatest_slope(const Surface& surface) {
  Numbers x;
  for (int i = -40; i <= 40; ++i) x.push_back(surface.half_width * i / 32);
  Numbers values;
  for (const exercise::Estimate& slope : slopes(surface, x)) values.push_back(slope.value);
  return greatest(values);
}

Outcome quadrature_is_right(const Program& program, const std::string& id) {
  // The triangle has only one place, because it has a closed form.
  const std::vector<Places> places = {{shape::triangle, {1}},
                                      {shape::smooth, {1e-3, 0.3, -0.9, 1, -1.8}},
                                      {shape::one_sided, {0, -0.6, -0.9999, -1, 1.0001, 5, -40}},
                                      {waves(id), {0.1, -0.4, 0.8, -1.2}}};
  Surface surface = surface_of(id);
  Tally tally("the slope by eq. (2) is right to 1e-7 of the greatest");
  for (const auto& [shape, xi] : places) {
    surface.shape = shape;
    const Numbers x = times(surface.half_width, xi);
    const Numbers found = ask(program, surface, x).value;
    const auto reference = slopes(surface, x);
    const double tolerance = 1e-7 * greatest_slope(surface);
    for (std::size_t i = 0; i < x.size(); ++i) {
      tally.part(near(found[i], reference[i].value, tolerance), place(xi[i], shape));
    }
  }
  return tally.outcome();
}

// Compares six digits, so that changes in the last digits do not turn a constant into an estimate.
bool are_all_the_same(const Numbers& errors) {
  return std::all_of(errors.begin(), errors.end(), [&](double error) {
    return near(error, errors.front(), 1e-6 * errors.front());
  });
}

// A solution may use a minimum for GSL's estimates, because they ignore rounding. It then reports
// the same error wherever GSL's estimate is smaller. Such a minimum is small; an invented constant
// is not.
constexpr double most_of_a_minimum = 1e-9;

Outcome quadrature_is_honest(const Program& program, const std::string& id) {
  const std::vector<Places> places = {{shape::triangle, {0.77}},
                                      {shape::smooth, {0.05, -0.35, -0.98, 1.02, 2.5}},
                                      {shape::one_sided, {0.4, -0.7, 0.98, -1.02, -1.3, -12}},
                                      {waves(id), {0.3, -0.6, 0.9, 1.1}}};
  Surface surface = surface_of(id);
  Tally tally(
      "the true slope is within the reported error, which is at most 1e-6 of the greatest slope");
  for (const auto& [shape, xi] : places) {
    surface.shape = shape;
    const Numbers x = times(surface.half_width, xi);
    const Answer q = ask(program, surface, x);
    const auto truth = slopes(surface, x);
    const double slope = greatest_slope(surface);
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double reported = q.abs_error[i];
      const bool is_plausible = reported > 0 && reported <= most_reported * slope;
      const double margin = reported + truth[i].abs_error;
      tally.part(is_plausible && near(q.value[i], truth[i].value, margin), place(xi[i], shape));
    }
    const bool is_large = q.abs_error.front() > most_of_a_minimum * slope;
    if (x.size() > 1 && is_large && are_all_the_same(q.abs_error)) {
      return {0,
              "the reported error is the same at all places of one load, and more than 1e-9 of the "
              "greatest slope"};
    }
  }
  return tally.outcome();
}

}  // namespace

Checks hidden_checks() {
  return {{"quadrature-reference", quadrature_is_right},
          {"quadrature-honest", quadrature_is_honest}};
}

}  // namespace assignment::quadrature
