// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/conventions.hpp"

#include <algorithm>
#include <cmath>

#include "elasticity/loads.hpp"

namespace paper {

Estimate displacement(const HalfSpaceCase& c, double x) {
  const double logarithm = std::abs(std::log(c.datum / c.load.half_width()));
  return {normal_displacement(c.material, c.load, x, c.datum),
          1e-14 * displacement_scale(c) * (1 + logarithm)};
}

Estimate gradient(const HalfSpaceCase& c, double x) {
  const double value = normal_gradient(c.material, c.load, x);
  return {value, 1e-13 * std::abs(value)};
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

int decimals_of(const std::vector<double>& points) {
  constexpr int most = 9;
  for (int decimals = 0; decimals < most; ++decimals) {
    const double shift = std::pow(10.0, decimals);
    const auto is_printed = [shift](double x) {
      return std::abs(x * shift - std::round(x * shift)) <= 1e-9 * std::abs(x * shift);
    };
    if (std::ranges::all_of(points, is_printed)) return decimals;
  }
  return most;
}

Column column_of_points(const std::vector<double>& points, const std::string& unit) {
  return Column("$x$", fixed(decimals_of(points)), unit).exact();
}

}  // namespace paper
