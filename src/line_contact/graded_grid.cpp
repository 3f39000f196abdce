// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_contact/graded_grid.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "elasticity/piecewise_linear_load.hpp"

namespace line_contact {

using Eigen::Index;
using Eigen::MatrixXd;
using elasticity::element_potential;
using std::numbers::pi;

namespace {

double root_at(double from_edge) {
  return std::sqrt(from_edge * (2 - from_edge));
}

}  // namespace

ReferenceGrid::ReferenceGrid(long n_elements) : from_edge_(2 * n_elements + 1) {
  for (Index i = 0; i <= n_elements; ++i) {
    const double quarter_sine =
        std::sin(pi * static_cast<double>(i) / static_cast<double>(4 * n_elements));
    const double half_angle = pi / 2 * quarter_sine * quarter_sine;
    const double distance = 2 * std::sin(half_angle) * std::sin(half_angle);
    from_edge_[i] = from_edge_[n_nodes() - 1 - i] = distance;
  }
}

double ReferenceGrid::distance(Index from, Index to) const {
  const bool from_left = from <= n_nodes() / 2;
  const bool to_left = to <= n_nodes() / 2;
  if (from_left == to_left) {
    return from_left ? from_edge_[to] - from_edge_[from] : from_edge_[from] - from_edge_[to];
  }
  const double apart = 2 - from_edge_[from] - from_edge_[to];
  return from_left ? apart : -apart;
}

double ReferenceGrid::root(Index node) const {
  return root_at(from_edge_[node]);
}

double ReferenceGrid::middle_root(Index element) const {
  return root_at((from_edge_[element] + from_edge_[element + 1]) / 2);
}

double ReferenceGrid::x(Index node, Edges edges) const {
  const double a = (edges.right - edges.left) / 2;
  return node <= n_nodes() / 2 ? edges.left + a * from_edge_[node]
                               : edges.right - a * from_edge_[node];
}

// Row e: what nodal pressures add up to, above their mean, at the middle of element e: by the cubic
// through g = p/√((x − left)(right − x)) at four nodes around.
MatrixXd bulge_weights(const ReferenceGrid& grid) {
  MatrixXd weights = MatrixXd::Zero(grid.n_elements(), grid.n_nodes());
  for (Index e = 0; e < grid.n_elements(); ++e) {
    const Index first = std::clamp<Index>(e - 1, 1, grid.n_nodes() - 5);
    for (Index k = first; k < first + 4; ++k) {
      double weight = grid.middle_root(e) / grid.root(k);
      for (Index m = first; m < first + 4; ++m) {
        const double to_middle = grid.distance(m, e) + grid.length(e) / 2;
        if (m != k) weight *= to_middle / grid.distance(m, k);
      }
      weights(e, k) += weight;
    }
    weights.row(e).segment<2>(e).array() -= 0.5;
  }
  return weights;
}

// Eq. (1a) at each node and equilibrium, for the contact of half-width 1 and so for any: with
// φ = 2a p/(πE*), Σ V_ij φ_j + δ = h_i and Σ w_j φ_j = 2P/(πE*).
MatrixXd graded_system(const ReferenceGrid& grid, const MatrixXd& bulge) {
  const Index n = grid.n_nodes();
  MatrixXd matrix = MatrixXd::Zero(n + 1, n + 1);
  MatrixXd middle(n + 1, n - 1);
  for (Index e = 0; e + 1 < n; ++e) {
    for (Index i = 0; i < n; ++i) {
      const auto v = element_potential(grid.distance(i, e), grid.distance(i, e + 1));
      matrix(i, e) += v.begin;
      matrix(i, e + 1) += v.end;
      middle(i, e) = v.middle;
    }
    matrix.row(n).segment<2>(e).array() += grid.length(e) / 2;
    middle(n, e) = 2 * grid.length(e) / 3;
  }
  matrix.leftCols(n) += middle * bulge;
  matrix.col(n).head(n).setOnes();
  return matrix;
}

}  // namespace line_contact
