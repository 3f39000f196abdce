// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_contact/solution.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "elasticity/loads.hpp"
#include "elasticity/stress.hpp"
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

// Returns how far beyond the end node p² becomes zero, extrapolated from the last two nodes.
double overhang(double last, double last_but_one, double spacing) {
  const double fall = last_but_one * last_but_one - last * last;
  return fall > 0 ? spacing * std::min(1.0, last * last / fall) : spacing / 2;
}

// Returns the sum of both bodies' slopes at the distance x from an element of pressure p.
double slope_of(const elasticity::Material& both, Element element, double p, double c, double x) {
  switch (element) {
    case Element::triangular:
      return elasticity::normal_gradient(both, elasticity::TriangularLoad(p, c), x);
    case Element::uniform:
      return elasticity::normal_gradient(both, elasticity::UniformLoad(p, c / 2), x);
    case Element::point:
      break;
  }
  return elasticity::normal_gradient(both, elasticity::ConcentratedLoad(c * p), x);
}

// p = φ πE*/(2c)
double pressure_per_phi(const Problem& problem) {
  return std::numbers::pi * problem.contact_modulus / (2 * problem.grid.spacing);
}

void require_free_ends(const Solution& solution) {
  const Grid& grid = solution.grid;
  const bool at_begin = solution.pressure[0] > 0;
  if (!at_begin && !(solution.pressure[grid.n_nodes - 1] > 0)) return;
  const Profile& profile = solution.profile;
  const std::string limit = std::isfinite(profile.begin())
                                ? fmt::format(", and the profile is given from {:.6g} to {:.6g}",
                                              profile.begin(), profile.end())
                                : "";
  throw sys::InvalidQuantity("domain", grid.width(),
                             fmt::format("wider: the contact reaches its end at x = {:.6g}{}",
                                         at_begin ? grid.begin() : grid.end(), limit));
}

}  // namespace

contact::Resolution Solution::resolution() const {
  const Index n = n_in_contact();
  return {n, static_cast<double>(n), grid.n_nodes, grid.width()};
}

double Solution::half_width() const {
  // Moments in units of the peak and of the spacing do not underflow under very small loads.
  const double peak = peak_pressure();
  double load = 0;
  double moment = 0;
  double second_moment = 0;
  for (Index i = 0; i < grid.n_nodes; ++i) {
    const double p = pressure[i] / peak;
    const double x = (grid.x(i) - grid.centre) / grid.spacing;
    load += p;
    moment += p * x;
    second_moment += p * x * x;
  }
  const double mean = moment / load;
  return 2 * grid.spacing *
         std::sqrt(second_moment / load - mean * mean + own_second_moment(element));
}

std::vector<Region> regions_in_contact(const Grid& grid, const Eigen::VectorXd& pressure) {
  std::vector<Region> regions;
  const auto at = [&](Index i) { return i < 0 || i >= grid.n_nodes ? 0 : pressure[i]; };
  for (Index i = 0; i < grid.n_nodes; ++i) {
    if (!(at(i) > 0)) continue;
    Index j = i;
    double load = 0;
    for (; at(j) > 0; ++j) load += grid.spacing * at(j);
    regions.push_back({grid.x(i) - overhang(at(i), at(i + 1), grid.spacing),
                       grid.x(j - 1) + overhang(at(j - 1), at(j - 2), grid.spacing), load, j - i});
    i = j;
  }
  return regions;
}

// δ = h − g − (Tφ)_i + Σ_j T((datum − x_j)/c) φ_j at the node i of greatest pressure.
double Solution::approach(double datum) const {
  const std::vector<Region> in_contact = regions();
  const double begin = in_contact.empty() ? grid.centre : in_contact.front().begin;
  const double end = in_contact.empty() ? grid.centre : in_contact.back().end;
  if (!(std::isfinite(datum) && (datum < begin || datum > end))) {
    throw sys::InvalidQuantity(
        "datum", datum, fmt::format("outside the contact, from {:.6g} to {:.6g}", begin, end));
  }
  Index i = 0;
  pressure.maxCoeff(&i);
  double sum = 0;
  for (Index j = 0; j < grid.n_nodes; ++j) {
    if (pressure[j] == 0) continue;
    sum += pressure[j] * (influence_coefficient(element, (datum - grid.x(j)) / grid.spacing) -
                          influence_coefficient(element, static_cast<double>(i - j)));
  }
  return profile.gap(grid.x(i)) - gap[i] + sum / pressure_per_phi(*this);
}

double surface_slope(const Solution& solution, double x) {
  // With ν = 0 and E = E*, the factor 2(1−ν²)/(πE) is the sum of both bodies' factors.
  const elasticity::Material both(solution.contact_modulus, 0);
  const Grid& grid = solution.grid;
  double slope = 0;
  for (Index j = 0; j < grid.n_nodes; ++j) {
    const double p = solution.pressure[j];
    if (p != 0) slope += slope_of(both, solution.element, p, grid.spacing, x - grid.x(j));
  }
  return slope;
}

elasticity::Stress stress_beneath(const Solution& solution, double x, double z) {
  if (solution.element != Element::triangular) {
    throw sys::InvalidQuantity("width of the elements", solution.grid.spacing,
                               "that of triangular elements: beneath others the stress jumps");
  }
  // From the free node before the contact to the one behind it
  const Eigen::VectorXd& p = solution.pressure;
  Index first = 0;
  Index last = p.size() - 1;
  while (first + 2 < p.size() && !(p[first + 1] > 0)) ++first;
  while (last > first + 1 && !(p[last - 1] > 0)) --last;
  const auto n = static_cast<std::size_t>(last - first + 1);
  const Eigen::VectorXd nodes = solution.grid.nodes();
  return elasticity::stress_beneath({nodes.data() + first, n}, {p.data() + first, n}, x, z);
}

Solution to_solution(const Problem& problem, double line_load, NodalLoads loads) {
  Solution solution{
      {problem}, pressure_per_phi(problem) * loads.phi, std::move(loads.gap), loads.work, {}};
  require_free_ends(solution);
  contact::require_resolved(solution.resolution());
  solution.residuals = contact::residuals_of_gaps(solution.pressure, solution.gap);
  solution.residuals.pressure = loads.error * solution.peak_pressure();
  solution.residuals.load = std::abs(solution.line_load() - line_load);
  return solution;
}

}  // namespace line_contact
