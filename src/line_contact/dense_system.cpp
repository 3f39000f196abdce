// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_contact/dense_system.hpp"

#include <fmt/core.h>

#include <limits>

#include "line_contact/nested_grids.hpp"
#include "system/require.hpp"

namespace line_contact {

using Eigen::Index;
using Eigen::VectorXd;

DenseSystem::DenseSystem(const Problem& problem, double line_load)
    : is_one_sided_(problem.grid.is_one_sided) {
  require_valid(problem);
  sys::require_positive("load", line_load);
  const Grid& grid = problem.grid;
  if (grid.n_nodes > max_dense_nodes) {
    const auto n = static_cast<double>(grid.n_nodes);
    throw sys::InvalidQuantity(
        "nodes", n,
        fmt::format("from {} to {} for a dense method (its matrix would take {:.3g} GB); fft takes "
                    "more",
                    min_nodes, max_dense_nodes, 8e-9 * n * n));
  }
  influence_ = VectorXd::NullaryExpr(is_one_sided_ ? 2 * grid.n_nodes : grid.n_nodes, [&](Index k) {
    return influence_coefficient(problem.element, static_cast<double>(k));
  });
  initial_gap_ = grid.nodes().unaryExpr([&](double x) { return problem.profile.gap(x); });
  least_gap_ = initial_gap_.minCoeff();
  initial_gap_.array() -= least_gap_;
  weights_ = VectorXd::NullaryExpr(grid.n_nodes, [&](Index i) { return grid.weight(i); });
  total_ = total_phi(problem, line_load);
}

double DenseSystem::rounding_of_gap() const {
  constexpr double roundings = 64;
  return roundings * std::numeric_limits<double>::epsilon() * total_ *
         influence_.cwiseAbs().maxCoeff();
}

}  // namespace line_contact
