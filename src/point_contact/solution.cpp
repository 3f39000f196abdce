// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/solution.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

#include "system/require.hpp"

namespace point_contact {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// ⟨s sᵀ⟩ of one element about its node, in units of c²: each vector e along which the element is
// smeared adds eeᵀ/12.
Eigen::Matrix2d own_second_moment(Element element) {
  const Eigen::Matrix2d cell = Eigen::Matrix2d::Identity() / 12;
  if (element == Element::uniform) return cell;
  const Vector2 diagonal(-1, 1);
  return cell + diagonal * diagonal.transpose() / 12;
}

// ⟨x xᵀ⟩ about the mean of a density at the nodes. In units of c², very small contacts do not
// underflow.
template <class Density>
Eigen::Matrix2d second_moment(const Density& density, const Grid& grid) {
  double total = 0;
  Vector2 first = Vector2::Zero();
  Eigen::Matrix2d second = Eigen::Matrix2d::Zero();
  for (Index j = 0; j < grid.n2; ++j) {
    for (Index i = 0; i < grid.n1; ++i) {
      const double p = density(grid.index(i, j));
      if (p == 0) continue;
      const Vector2 x = grid.node(i, j) / grid.spacing;
      total += p;
      first += p * x;
      second += p * x * x.transpose();
    }
  }
  const Vector2 mean = first / total;
  return second / total - mean * mean.transpose();
}

// The roots of the eigenvalues of a symmetric matrix, the greater first.
Vector2 roots_of_eigenvalues(const Eigen::Matrix2d& moment) {
  const double half_trace = moment.trace() / 2;
  const double spread = std::hypot((moment(0, 0) - moment(1, 1)) / 2, moment(0, 1));
  return {std::sqrt(half_trace + spread), std::sqrt(half_trace - spread)};
}

void require_free_ends(const Solution& solution) {
  const Grid& grid = solution.grid;
  bool is_free = true;
  for (Index i = 0; i < grid.n1; ++i) {
    is_free = is_free && solution.pressure[grid.index(i, 0)] == 0 &&
              solution.pressure[grid.index(i, grid.n2 - 1)] == 0;
  }
  for (Index j = 0; j < grid.n2; ++j) {
    is_free = is_free && solution.pressure[grid.index(0, j)] == 0 &&
              solution.pressure[grid.index(grid.n1 - 1, j)] == 0;
  }
  if (is_free) return;
  const bool is_measured = std::isfinite(solution.profile.half_sides().maxCoeff());
  throw sys::InvalidQuantity("domain", static_cast<double>(grid.n1) * grid.spacing,
                             is_measured ? "wider: the contact reaches the end of the grid, which "
                                           "must lie within the measured surface"
                                         : "wider: the contact reaches the end of the grid");
}

constexpr std::array<std::pair<Index, Index>, 6> neighbours = {
    {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {-1, 1}, {1, -1}}};

// Traverses the region of one node in contact, removing its nodes from `to_visit`.
Region region_around(const Solution& solution, Index first, std::vector<bool>& to_visit) {
  const Grid& grid = solution.grid;
  Region region{Vector2::Zero(), 0, 0, 0};
  std::vector<Index> open{first};
  to_visit[size_of(first)] = false;
  while (!open.empty()) {
    const Index node = open.back();
    open.pop_back();
    const Index i = node % grid.n1;
    const Index j = node / grid.n1;
    region.load += solution.pressure[node];
    region.centre += solution.pressure[node] * grid.node(i, j);
    ++region.n_nodes;
    for (const auto& [di, dj] : neighbours) {
      if (i + di < 0 || i + di >= grid.n1 || j + dj < 0 || j + dj >= grid.n2) continue;
      const Index next = grid.index(i + di, j + dj);
      if (!to_visit[size_of(next)]) continue;
      to_visit[size_of(next)] = false;
      open.push_back(next);
    }
  }
  region.centre /= region.load;
  region.area = static_cast<double>(region.n_nodes) * grid.cell_area();
  region.load *= grid.cell_area();
  return region;
}

}  // namespace

contact::Resolution Solution::resolution() const {
  const Eigen::Map<const Eigen::ArrayXXd> p(pressure.data(), grid.n1, grid.n2);
  const auto n_columns = static_cast<double>((p > 0).rowwise().any().count());
  const auto n_rows = static_cast<double>((p > 0).colwise().any().count());
  const Index n = n_in_contact();
  const double diameter = 2 * std::sqrt(static_cast<double>(n) / std::numbers::pi);
  const Index longer = std::max(grid.n1, grid.n2);
  return {n, std::min({n_columns, n_rows, diameter}), longer,
          static_cast<double>(longer) * grid.spacing};
}

Vector2 Solution::semi_axes() const {
  // In units of the peak, very small loads do not underflow.
  const double peak = peak_pressure();
  const auto density = [&](Index node) { return pressure[node] / peak; };
  const double of_a_hertzian_pressure = std::sqrt(5.0);
  return grid.spacing * of_a_hertzian_pressure *
         roots_of_eigenvalues(second_moment(density, grid) + own_second_moment(element));
}

Vector2 Solution::area_semi_axes() const {
  const auto density = [&](Index node) { return pressure[node] > 0 ? 1.0 : 0.0; };
  constexpr double of_a_uniform_density = 2;
  return grid.spacing * of_a_uniform_density *
         roots_of_eigenvalues(second_moment(density, grid) + own_second_moment(Element::uniform));
}

Solution to_solution(const Problem& problem, double load, NodalLoads loads) {
  const double pressure_per_phi = std::numbers::pi * problem.contact_modulus / problem.grid.spacing;
  Solution solution{
      {problem}, pressure_per_phi * loads.phi, std::move(loads.gap), loads.approach, loads.work,
      {}};
  require_free_ends(solution);
  contact::require_resolved(solution.resolution());
  solution.residuals = contact::residuals_of_gaps(solution.pressure, solution.gap);
  solution.residuals.pressure = loads.error * solution.peak_pressure();
  solution.residuals.load = std::abs(solution.load() - load);
  return solution;
}

std::vector<Region> regions(const Solution& solution) {
  const Index n = solution.pressure.size();
  std::vector<bool> to_visit(size_of(n));
  for (Index node = 0; node < n; ++node) to_visit[size_of(node)] = solution.pressure[node] > 0;
  std::vector<Region> found;
  for (Index node = 0; node < n; ++node) {
    if (to_visit[size_of(node)]) found.push_back(region_around(solution, node, to_visit));
  }
  std::ranges::stable_sort(found, std::greater<>(), &Region::load);
  return found;
}

}  // namespace point_contact
