// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "literate/claims/criterion.hpp"
#include "paper/prelude.hpp"

namespace paper {

/// What one would not see in a plot: a hundredth of what it shows.
inline Limit less_than_a_plot_shows() {
  return {literate::LimitKind::choice, 1e-2, "less than a plot shows"};
}

/// What the paper calls nearly identical, or negligible, of curves that a plot compares.
inline Limit nearly_identical() {
  return {literate::LimitKind::choice, 3e-2, "about what can be read off the axes of a plot"};
}

/// The square of the element width over the half-width of the contact, for errors of linear
/// elements.
inline Limit of_second_order(double square) {
  return {literate::LimitKind::choice, square,
          "(𝑐/𝑎)²; at the peak linear interpolation errs by an eighth of it"};
}

/// The number of criteria that hold.
inline long n_holding(const std::vector<Criterion>& criteria) {
  return std::ranges::count(criteria, literate::Outcome::holds, &Criterion::outcome);
}

/// Whether a fitted order of convergence is the expected one.
inline Criterion is_of_order(std::string what, const Measured& order, double expected) {
  const Limit nearest(literate::LimitKind::choice, 0.25,
                      "nearer to the order stated than to any other multiple of ½");
  return Criterion::agrees(std::move(what), Value(order, uncertain()), Value(expected, exact()),
                           nearest.counting(2));
}

/// The fewest decimals, at most nine, that print every one of the points exactly.
inline int decimals_of(const std::vector<double>& points) {
  constexpr int most = 9;
  for (int decimals = 0; decimals < most; ++decimals) {
    const double shift = std::pow(10.0, decimals);
    const auto is_printed = [shift](double x) {
      return std::abs(x * shift - std::round(x * shift)) <= 1e-9 * std::abs(x * shift);
    };
    if (std::all_of(points.begin(), points.end(), is_printed)) return decimals;
  }
  return most;
}

}  // namespace paper
