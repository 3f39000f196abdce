// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstddef>
#include <numbers>
#include <vector>

#include "assignment/exercises/quadrature.hpp"
#include "assignment/exercises/surface_hidden.hpp"

namespace assignment::quadrature {
namespace {

// The greatest slope under a load of that shape in units of 2(1−ν²)p₀/(πE), to three digits.
double greatest_slope(const Surface& s) {
  const double unit =
      2 * (1 - s.poisson * s.poisson) * s.peak_pressure / (std::numbers::pi * s.young);
  switch (s.shape) {
    case Shape::triangle:
      return 1.76 * unit;
    case Shape::smooth:
      return 2.14 * unit;
    case Shape::one_sided:
      return 2.76 * unit;
  }
  return 0;
}

// The triangle has few points, because it has a closed form.
const std::vector<Places> quadrature_places = {
    {Shape::triangle, {1}},
    {Shape::smooth, {1e-3, 0.3, -0.9, 1, -1.8}},
    {Shape::one_sided, {0, -0.6, -0.9999, -1, 1.0001, 5, -40}}};

Outcome quadrature_is_right(const Program& program, const Variant& variant) {
  Surface surface = surface_of(variant);
  Tally tally("the slope by eq. (2) is right to 1e-7 of the greatest");
  for (const auto& [shape, xi] : quadrature_places) {
    surface.shape = shape;
    const Numbers x = times(surface.half_width, xi);
    const Numbers found = ask(program, surface, x).value;
    const auto reference = reference_of(surface);
    for (std::size_t i = 0; i < x.size(); ++i) {
      tally.part(
          near(found[i], reference.normal_gradient(x[i]).value, 1e-7 * greatest_slope(surface)),
          place(xi[i], shape));
    }
  }
  return tally.outcome();
}

// To six digits, so that a last place or two that is added makes no estimate of a constant.
bool are_all_the_same(const Numbers& errors) {
  return std::all_of(errors.begin(), errors.end(), [&](double error) {
    return near(error, errors.front(), 1e-6 * errors.front());
  });
}

// Whoever adds a least value to GSL's estimates, for the rounding that they leave out, reports the
// same error where GSL finds less. Such a value is small; a constant that is invented to be safe is
// not.
constexpr double most_of_a_least_value = 1e-9;

Outcome quadrature_is_honest(const Program& program, const Variant& variant) {
  const std::vector<Places> places = {{Shape::triangle, {0.77}},
                                      {Shape::smooth, {0.05, -0.35, -0.98, 1.02, 2.5}},
                                      {Shape::one_sided, {0.4, -0.7, 0.98, -1.02, -1.3, -12}}};
  Surface surface = surface_of(variant);
  Tally tally(
      "the truth is within the reported error, which is at most 1e-6 of the greatest slope");
  for (const auto& [shape, xi] : places) {
    surface.shape = shape;
    const Numbers x = times(surface.half_width, xi);
    const Answer q = ask(program, surface, x);
    const auto reference = reference_of(surface);
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double reported = q.abs_error[i];
      const bool says_something = reported > 0 && reported <= 1e-6 * greatest_slope(surface);
      const auto truth = reference.normal_gradient(x[i]);
      const double margin = reported + truth.abs_error;
      tally.part(says_something && near(q.value[i], truth.value, margin), place(xi[i], shape));
    }
    const bool is_large = q.abs_error.front() > most_of_a_least_value * greatest_slope(surface);
    if (x.size() > 1 && is_large && are_all_the_same(q.abs_error)) {
      return {0,
              "the reported error is the same number at all places of one load, and more than 1e-9 "
              "of the greatest slope"};
    }
  }
  return tally.outcome();
}

}  // namespace

/// The checks that compare with this project's own functions. Their messages give none of the
/// expected numbers.
course::Checks hidden_checks() {
  return {{"quadrature-reference", quadrature_is_right},
          {"quadrature-honest", quadrature_is_honest}};
}

}  // namespace assignment::quadrature
