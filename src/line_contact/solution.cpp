// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_contact/solution.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "system/require.hpp"

namespace line_contact {
namespace {

using Eigen::Index;

// Returns ⟨s²⟩ of one element about its node, in units of c².
double own_second_moment(Element element) {
  switch (element) {
    case Element::triangular:
      return 1. / 6;
    case Element::uniform:
      return 1. / 12;
    case Element::point:
      break;
  }
  return 0;
}

// Returns how far beyond the end node p² becomes zero if it goes on falling as between the last two
// nodes.
double overhang(double last, double last_but_one, double spacing) {
  const double fall = last_but_one * last_but_one - last * last;
  return fall > 0 ? spacing * std::min(1.0, last * last / fall) : spacing / 2;
}

}  // namespace

double Solution::line_load() const {
  double sum = 0;
  for (Index i = 0; i < grid.n_nodes; ++i) sum += grid.weight(i) * pressure[i];
  return grid.spacing * sum;
}

double Solution::half_width() const {
  // The moment is taken in units of the peak and of the spacing, because under very small loads it
  // would underflow.
  const double peak = peak_pressure();
  double load = 0;
  double moment = 0;
  double second_moment = 0;
  for (Index i = 0; i < grid.n_nodes; ++i) {
    const double p = grid.weight(i) * pressure[i] / peak;
    const double x = (grid.x(i) - grid.centre) / grid.spacing;
    load += p;
    if (!grid.is_one_sided) moment += p * x;
    second_moment += p * x * x;
  }
  const double mean = moment / load;
  const double own = own_second_moment(element);
  return 2 * grid.spacing * std::sqrt(second_moment / load - mean * mean + own);
}

double Solution::half_width_by_count() const {
  double count = 0;
  for (Index i = 0; i < grid.n_nodes; ++i) {
    if (pressure[i] > 0) count += grid.weight(i);
  }
  return count * grid.spacing / 2;
}

std::vector<Region> regions_in_contact(const Grid& grid, const Eigen::VectorXd& pressure) {
  std::vector<Region> regions;
  const auto at = [&](Index i) { return i < 0 || i >= grid.n_nodes ? 0 : pressure[i]; };
  for (Index i = 0; i < grid.n_nodes; ++i) {
    if (!(at(i) > 0)) continue;
    Index j = i;
    double load = 0;
    for (; at(j) > 0; ++j) load += grid.weight(j) * grid.spacing * at(j);
    const double begin = grid.x(i) - overhang(at(i), at(i + 1), grid.spacing);
    const double end = grid.x(j - 1) + overhang(at(j - 1), at(j - 2), grid.spacing);
    const bool is_mirrored = grid.is_one_sided && i == 0;
    regions.push_back({is_mirrored ? -end : begin, end, load, j - i});
    i = j;
  }
  return regions;
}

double Solution::approach(double datum) const {
  const std::vector<Region> in_contact = regions();
  const double begin = in_contact.empty() ? 0 : in_contact.front().begin;
  const double end = in_contact.empty() ? 0 : in_contact.back().end;
  const double left = grid.is_one_sided ? -end : begin;
  if (!(std::isfinite(datum) && (datum < left || datum > end))) {
    throw sys::InvalidQuantity(
        "datum", datum, fmt::format("outside the contact, from {:.6g} to {:.6g}", left, end));
  }
  const auto potential = [&](double x) {
    return influence_coefficient(element, (datum - x) / grid.spacing);
  };
  double sum = 0;
  for (Index j = 0; j < grid.n_nodes; ++j) {
    if (pressure[j] == 0) continue;
    const double x = grid.x(j);
    const double both = grid.weight(j) == 2 ? potential(x) + potential(-x) : potential(x);
    sum += both * pressure[j];
  }
  return approach_at_spacing + sum / pressure_per_phi;
}

Solution to_solution(const Problem& problem, double line_load, ElementLoads loads) {
  const double pressure_per_phi =
      std::numbers::pi * problem.contact_modulus / (2 * problem.grid.spacing);
  Solution solution{.grid = problem.grid,
                    .element = problem.element,
                    .pressure = pressure_per_phi * loads.phi,
                    .gap = std::move(loads.gap),
                    .pressure_per_phi = pressure_per_phi,
                    .approach_at_spacing = loads.approach_at_spacing,
                    .work = loads.work,
                    .residuals = {}};
  solution.residuals = contact::residuals_of_gaps(solution.pressure, solution.gap);
  solution.residuals.pressure = loads.error * solution.peak_pressure();
  solution.residuals.load = std::abs(solution.line_load() - line_load);
  return solution;
}

}  // namespace line_contact
