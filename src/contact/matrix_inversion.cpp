// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/matrix_inversion.hpp"

#include <fmt/core.h>

#include <Eigen/LU>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "elasticity/triangular_load.hpp"
#include "numerics/require.hpp"

namespace contact {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Indices = std::vector<Index>;

Index at(const Indices& indices, Index i) {
  return indices[static_cast<std::size_t>(i)];
}

// The contact with pressures in units of length, φ_j = 2c p_j/(πE*), so that every coefficient of
// its equations is of order one:  Σ_j T(i−j) φ_j + δ = h_i,  Σ φ = 2P/(πE*).
struct System {
  VectorXd influence;    // T(0), T(1), …
  VectorXd initial_gap;  // h
  double total;          // 2P/(πE*)

  Index size() const { return initial_gap.size(); }
  double coefficient(Index i, Index j) const { return influence[std::abs(i - j)]; }
};

struct State {
  VectorXd phi;
  VectorXd gap;
  double approach = 0;
};

// begin excerpt: matrix-inversion
// Eq. (1a) at each node in contact, and equilibrium, as one linear system.
State solve_for_contact(const System& system, const Indices& contact) {
  const Index n = std::ssize(contact);
  MatrixXd matrix = MatrixXd::Ones(n + 1, n + 1);
  VectorXd right_side = VectorXd::Constant(n + 1, system.total);
  for (Index j = 0; j < n; ++j) {
    for (Index i = 0; i < n; ++i) matrix(i, j) = system.coefficient(at(contact, i), at(contact, j));
    right_side[j] = system.initial_gap[at(contact, j)];
  }
  matrix(n, n) = 0;
  const VectorXd unknowns = matrix.partialPivLu().solve(right_side);

  State state{VectorXd::Zero(system.size()), {}, unknowns[n]};
  for (Index j = 0; j < n; ++j) state.phi[at(contact, j)] = unknowns[j];
  return state;
}

// u_z1 + u_z2 + h − δ at every node.
VectorXd gap_of(const System& system, const State& state, const Indices& contact) {
  VectorXd gap = system.initial_gap.array() - state.approach;
  for (Index i = 0; i < system.size(); ++i) {
    for (const Index j : contact) gap[i] -= system.coefficient(i, j) * state.phi[j];
  }
  return gap;
}

// Nodes in tension leave the contact, nodes that penetrate enter it.
Indices revised_contact(const State& state, const Indices& contact, double smallest_gap) {
  std::vector<bool> in_contact(static_cast<std::size_t>(state.gap.size()), false);
  for (const Index i : contact) in_contact[static_cast<std::size_t>(i)] = true;
  Indices revised;
  for (Index i = 0; i < state.gap.size(); ++i) {
    const bool stays =
        in_contact[static_cast<std::size_t>(i)] ? state.phi[i] > 0 : state.gap[i] < -smallest_gap;
    if (stays) revised.push_back(i);
  }
  return revised;
}
// end excerpt: matrix-inversion

System system_of(const CylinderPair& cylinders, double line_load, const Grid& grid) {
  System system;
  system.influence = VectorXd::NullaryExpr(grid.n_nodes, [](Index k) {
    return elasticity::triangular_potential(static_cast<double>(k), 1);
  });
  system.initial_gap = grid.nodes().unaryExpr([&](double x) { return cylinders.initial_gap(x); });
  system.total = 2 * line_load / (std::numbers::pi * cylinders.contact_modulus());
  return system;
}

// A gap is only as good as the rounding of the terms that make it.
double rounding_of_gap(const System& system) {
  constexpr double roundings = 64;
  const double magnitude =
      system.total * system.influence.cwiseAbs().maxCoeff() + system.initial_gap.maxCoeff();
  return roundings * std::numeric_limits<double>::epsilon() * magnitude;
}

Residuals residuals_of(const Solution& solution, const Indices& contact, double line_load) {
  VectorXd outside = solution.gap;
  double misfit = 0;
  for (const Index i : contact) {
    misfit = std::max(misfit, std::abs(solution.gap[i]));
    outside[i] = 0;
  }
  return {misfit, std::max(0.0, -outside.minCoeff()), std::max(0.0, -solution.pressure.minCoeff()),
          std::abs(solution.line_load() - line_load)};
}

}  // namespace

double Solution::half_width() const {
  const double second_moment = pressure.dot(grid.nodes().cwiseAbs2()) / pressure.sum();
  return 2 * std::sqrt(second_moment + grid.spacing * grid.spacing / 6);
}

double Solution::approach(double datum) const {
  const double end = grid.x(grid.n_nodes - 1);
  if (!(std::isfinite(datum) && std::abs(datum) > end)) {
    throw numerics::InvalidQuantity("datum", datum, fmt::format("beyond the grid's end {}", end));
  }
  double sum = approach_at_spacing;
  for (Index j = 0; j < grid.n_nodes; ++j) {
    sum += elasticity::triangular_potential(datum - grid.x(j), grid.spacing) * phi[j];
  }
  return sum;
}

Solution solve_by_matrix_inversion(const CylinderPair& cylinders, double line_load,
                                   const Grid& grid) {
  numerics::require_positive("load", line_load);
  const System system = system_of(cylinders, line_load, grid);
  const double smallest_gap = rounding_of_gap(system);

  // Begin with every node in contact and let the tension at the ends peel off.
  Indices contact(static_cast<std::size_t>(grid.n_nodes));
  for (std::size_t i = 0; i < contact.size(); ++i) contact[i] = static_cast<Index>(i);
  constexpr int max_solves = 100;
  State state;
  int n_solves = 0;
  for (bool settled = false; !settled;) {
    if (++n_solves > max_solves) {
      throw ContactError(fmt::format("the contact did not settle in {} solves", max_solves));
    }
    state = solve_for_contact(system, contact);
    state.gap = gap_of(system, state, contact);
    Indices revised = revised_contact(state, contact, smallest_gap);
    settled = revised == contact;
    contact = std::move(revised);
  }
  if (contact.front() == 0 || contact.back() == grid.n_nodes - 1) {
    throw ContactError(
        fmt::format("the contact reaches the end of the grid at x = {}: take a wider grid",
                    grid.x(grid.n_nodes - 1)));
  }

  // Back to stresses.
  const double stress_per_length =
      std::numbers::pi * cylinders.contact_modulus() / (2 * grid.spacing);
  Solution solution{.grid = grid,
                    .pressure = stress_per_length * state.phi,
                    .gap = state.gap,
                    .phi = state.phi,
                    .approach_at_spacing = state.approach,
                    .n_in_contact = std::ssize(contact),
                    .n_solves = n_solves,
                    .residuals = {}};
  solution.residuals = residuals_of(solution, contact, line_load);
  return solution;
}

}  // namespace contact
