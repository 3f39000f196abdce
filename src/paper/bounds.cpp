// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/bounds.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "paper/prelude.hpp"

namespace paper {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

}  // namespace

double rounded(double x) {
  return 8 * epsilon * std::abs(x);
}

Estimate closed_form(double x) {
  return {x, rounded(x)};
}

double rounded(const ContactCase& c, double x) {
  const double magnitudes =
      std::abs(c.body1.radius.curvature()) + std::abs(c.body2.radius.curvature());
  return rounded(x) * magnitudes / c.cylinders.relative_curvature();
}

Estimate percent_off(Estimate a, const PrintedNumber& b) {
  return 100 * (a / as_estimate(b) - 1);
}

Estimate other_component(const PrintedNumber& magnitude, const PrintedNumber& component) {
  const auto root = [](double difference, double sum) {
    return std::sqrt(std::max(0.0, difference) * sum);
  };
  const Estimate difference = as_estimate(magnitude) - as_estimate(component);
  const Estimate sum = as_estimate(magnitude) + as_estimate(component);
  const double value = root(difference.value, sum.value);
  const double least = root(difference.value - difference.abs_error, sum.value - sum.abs_error);
  const double most = root(difference.value + difference.abs_error, sum.value + sum.abs_error);
  return {value, std::max(value - least, most - value)};
}

Estimate as_estimate(const PrintedNumber& number) {
  return {number.value(), number.last_place() / 2};
}

Estimate displacement(const HalfSpaceCase& c, double x) {
  const double scale = c.material.integral_compliance() * c.load.line_load();
  const double logarithm = std::abs(std::log(c.datum / c.load.half_width()));
  return {normal_displacement(c.material, c.load, x, c.datum), 1e-14 * scale * (1 + logarithm)};
}

Estimate gradient(const HalfSpaceCase& c, double x) {
  const double value = normal_gradient(c.material, c.load, x);
  return {value, 1e-13 * std::abs(value)};
}

double pressure_error(const line_contact::Solution& solution) {
  const auto n = static_cast<double>(solution.n_in_contact());
  return 4 * solution.residuals.pressure / solution.peak_pressure() + 16 * epsilon * std::sqrt(n);
}

double half_width_error(const line_contact::Solution& solution) {
  constexpr double of_pressures = 1.5;  // (16/(3π) + 4/π)/2
  return of_pressures * pressure_error(solution) + 8 * epsilon;
}

double edge_error(const line_contact::Solution& solution) {
  // The edge lies at c p₁²/(p₂² − p₁²) beyond the last node. With δ the error of either pressure it
  // moves by some 4cδ/p₁, and p₁ is not less than the least pressure of all.
  double least = solution.peak_pressure();
  for (const double p : solution.pressure) {
    if (p > 0) least = std::min(least, p);
  }
  const double share = 4 * pressure_error(solution) * solution.peak_pressure() / least;
  return solution.grid.spacing *
         std::min(1.0, share + 8 * epsilon / solution.grid.spacing * solution.half_width());
}

double bound_of_radius(double of_pressure) {
  return 2 * of_pressure;
}

double bound_of_approach(double of_pressure) {
  return 1.3 * of_pressure;
}

}  // namespace paper
