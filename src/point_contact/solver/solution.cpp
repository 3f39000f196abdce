// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/solver/solution.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "system/require.hpp"

namespace point_contact {
namespace {

using Eigen::Index;

// ⟨s sᵀ⟩ of one element about its node: each vector e that it is smeared along adds eeᵀ/12.
Eigen::Matrix2d own_second_moment(Element element, const Lattice& lattice) {
  const Vector2& a = lattice.first;
  const Vector2& b = lattice.second;
  const Eigen::Matrix2d cell = (a * a.transpose() + b * b.transpose()) / 12;
  switch (element) {
    case Element::point:
      return Eigen::Matrix2d::Zero();
    case Element::uniform:
      return cell;
    case Element::bilinear:
      return 2 * cell;
    case Element::pyramid:
      break;
  }
  return cell + (b - a) * (b - a).transpose() / 12;
}

// ⟨x xᵀ⟩ about the mean of a density at the nodes.
template <class Density>
Eigen::Matrix2d second_moment(const Density& density, const Grid& grid) {
  // In units of the spacing, which very small contacts need.
  const double scale = grid.spacing();
  double total = 0;
  Vector2 first = Vector2::Zero();
  Eigen::Matrix2d second = Eigen::Matrix2d::Zero();
  for (Index j = 0; j < grid.n2; ++j) {
    for (Index i = 0; i < grid.n1; ++i) {
      const double p = density(grid.index(i, j));
      if (p == 0) continue;
      const Vector2 x = (grid.node(i, j) - grid.centre) / scale;
      total += p;
      first += p * x;
      second += p * x * x.transpose();
    }
  }
  const Vector2 mean = first / total;
  return scale * scale * (second / total - mean * mean.transpose());
}

// The roots of `factor` times the eigenvalues of a symmetric matrix, the greater first.
Vector2 axes_of(const Eigen::Matrix2d& moment, double factor) {
  const double half_trace = moment.trace() / 2;
  const double spread = std::hypot((moment(0, 0) - moment(1, 1)) / 2, moment(0, 1));
  return {std::sqrt(factor * (half_trace + spread)), std::sqrt(factor * (half_trace - spread))};
}

}  // namespace

Eigen::Index Solution::n_in_contact() const {
  return (pressure.array() > 0).count();
}

double Solution::load() const {
  return grid.lattice.cell_area() * pressure.sum();
}

double Solution::peak_pressure() const {
  return pressure.maxCoeff();
}

double Solution::contact_area() const {
  return grid.lattice.cell_area() * static_cast<double>(n_in_contact());
}

Vector2 Solution::semi_axes() const {
  // In units of the peak, which very small loads need.
  const double peak = peak_pressure();
  constexpr double of_a_hertzian_pressure = 5;
  return axes_of(second_moment([&](Index node) { return pressure[node] / peak; }, grid) +
                     own_second_moment(element, grid.lattice),
                 of_a_hertzian_pressure);
}

Vector2 Solution::area_semi_axes() const {
  constexpr double of_a_uniform_density = 4;
  return axes_of(second_moment([&](Index node) { return pressure[node] > 0 ? 1 : 0; }, grid) +
                     own_second_moment(Element::uniform, grid.lattice),
                 of_a_uniform_density);
}

double total_phi(const Problem& problem, double load) {
  sys::require_positive("load", load);
  const double total = load / (std::numbers::pi * problem.contact_modulus * problem.grid.spacing());
  if (!(total < largest_length)) {
    throw sys::InvalidQuantity("load", load, "less: its square must be a double");
  }
  return total;
}

Solution to_solution(const Problem& problem, double load, ElementLoads loads) {
  const double pressure_per_phi =
      std::numbers::pi * problem.contact_modulus / problem.grid.spacing();
  loads.phi *= pressure_per_phi;
  Solution solution{.grid = problem.grid,
                    .element = problem.element,
                    .pressure = std::move(loads.phi),
                    .gap = std::move(loads.gap),
                    .approach = loads.approach,
                    .work = loads.work,
                    .residuals = {}};
  solution.residuals = contact::residuals_of_gaps(solution.pressure, solution.gap);
  solution.residuals.pressure = loads.error * solution.peak_pressure();
  solution.residuals.load = std::abs(solution.load() - load);
  return solution;
}

}  // namespace point_contact
