// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/solver/problem.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <cmath>

#include "point_contact/solver/influence_operator.hpp"
#include "system/require.hpp"

namespace point_contact {
namespace {

using Eigen::Index;

void require_within_profile(const Problem& problem) {
  const Grid& grid = problem.grid;
  const Vector2& half_sides = problem.profile.half_sides();
  for (const Index j : {Index{0}, Index{1}, grid.n2 - 1}) {
    for (const Index i : {Index{0}, grid.n1 - 1}) {
      const Vector2 corner = grid.node(i, j);
      if (!(corner.array().abs() <= half_sides.array()).all()) {
        throw sys::InvalidQuantity(
            "grid's corner x", corner.x(),
            fmt::format("within the measured surface, |x| ≤ {}, |y| ≤ {}; it lies at y = {}",
                        half_sides.x(), half_sides.y(), corner.y()));
      }
    }
  }
}

}  // namespace

Eigen::VectorXd initial_gaps(const Problem& problem, const RowTeam& team) {
  sys::require_positive("contact_modulus", problem.contact_modulus);
  const Grid& grid = problem.grid;
  require_memory(grid.n1, grid.n2);
  require_within_profile(problem);
  Eigen::VectorXd gaps(grid.size());
  constexpr double cost_of_gap = 30;
  team.for_rows(grid.n2, cost_of_gap * static_cast<double>(grid.n1), [&](Index j) {
    for (Index i = 0; i < grid.n1; ++i)
      gaps[grid.index(i, j)] = problem.profile.gap(grid.node(i, j));
  });
  const double least = gaps.minCoeff();
  if (!(least < largest_length)) {
    throw sys::InvalidQuantity("least gap", least,
                               fmt::format("less than {} at one node at least", largest_length));
  }
  return gaps;
}

namespace {

double bytes_of_machine() {
  return static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
}

}  // namespace

void require_memory(Eigen::Index n1, Eigen::Index n2) {
  // Nine fields of doubles, the mask of the contact, and as much as two fields in between.
  constexpr double bytes_of_fields = 9 * 8 + 1 + 16;
  const auto n_nodes = static_cast<double>(n1) * static_cast<double>(n2);
  constexpr double billions = 1e18;  // beyond, even the sizes are no numbers of the machine
  const double need = bytes_of_fields * n_nodes +
                      (n_nodes < billions ? InfluenceOperator::bytes(n1, n2) : 80 * n_nodes);
  if (need <= bytes_of_machine()) return;
  throw sys::InvalidQuantity(
      "nodes", n_nodes,
      fmt::format("fewer: these need {:.3g} GB of memory, and there are {:.3g} "
                  "GB",
                  1e-9 * need, 1e-9 * bytes_of_machine()));
}

}  // namespace point_contact
