// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_contact/graded_contact.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "contact/contact_search.hpp"
#include "numerics/dense_lu.hpp"
#include "system/require.hpp"

namespace line_contact {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;
using std::numbers::pi;

// A contact whose edges are given, so that only the pressures are unknown.
class GivenEdges {
 public:
  GivenEdges(const Profile& profile, double total, long n_elements)
      : profile_(profile),
        total_(total),
        grid_(n_elements),
        bulge_(bulge_weights(grid_)),
        matrix_(graded_system(grid_, bulge_)) {}

  const ReferenceGrid& grid() const { return grid_; }
  const MatrixXd& bulge() const { return bulge_; }

  // Returns φ at the nodes, then δ − h(centre). h enters by its differences, because those of a
  // small contact would be lost in h itself.
  VectorXd solve(Edges edges) const {
    const double centre = grid_.x(grid_.n_nodes() / 2, edges);
    VectorXd right_side(grid_.n_nodes() + 1);
    for (Index i = 0; i < grid_.n_nodes(); ++i) {
      right_side[i] = profile_.rise(centre, grid_.x(i, edges));
    }
    right_side[grid_.n_nodes()] = total_;  // Σ w φ = 2P/(πE*)
    return matrix_.solve(right_side);
  }

  // Returns p at the left edge and −p at the right, over the mean pressure. Both must vanish. A
  // singular pressure at an edge is the energy that moving it releases, so this is a gradient, of a
  // function of the edges that is convex if the profile is.
  Vector2d gradient(Edges edges) const {
    const VectorXd phi = solve(edges);
    const double a = (edges.right - edges.left) / 2;
    return Vector2d(phi[0], -phi[grid_.n_nodes() - 1]) / (a * total_);
  }

 private:
  const Profile& profile_;
  double total_;  // 2P/(πE*)
  ReferenceGrid grid_;
  MatrixXd bulge_;
  numerics::DenseLu matrix_;
};

Edges moved(const Profile& profile, Edges edges, const Vector2d& step) {
  return {std::max(edges.left + step[0], profile.begin()),
          std::min(edges.right + step[1], profile.end())};
}

// Newton's step towards a zero gradient, its derivatives by differences taken inwards; at most half
// the half-width. Where nothing depends on the place, as inside a flat, a little curvature keeps
// the matrix regular; it delays convergence by as little. Where the function curves down, between
// two hills, the step is along the gradient.
Vector2d newton_step(const GivenEdges& contact, Edges edges) {
  // Differentiate the gradient g(b) by differences: H = ∂g/∂b, b the two edges
  const double a = (edges.right - edges.left) / 2;
  const double difference =
      1e-5 *
      a;  // for this step the error of truncation and the rounding of the gradient are of one size
  const Vector2d gradient = contact.gradient(edges);
  Eigen::Matrix2d slope;
  slope.col(0) = contact.gradient({edges.left + difference, edges.right}) - gradient;
  slope.col(1) = gradient - contact.gradient({edges.left, edges.right - difference});
  slope /= difference;
  slope.diagonal().array() += 1e-6 * slope.cwiseAbs().maxCoeff();

  // Solve H s = −g by Cramer's rule
  const double determinant = slope(0, 0) * slope(1, 1) - slope(0, 1) * slope(1, 0);
  Vector2d step(slope(0, 1) * gradient[1] - slope(1, 1) * gradient[0],
                slope(1, 0) * gradient[0] - slope(0, 0) * gradient[1]);
  step /= determinant;

  // Turn the step downhill, s = −a² g, where it would go up, (s, g) ≥ 0; and shorten it to |s| ≤
  // a/2
  if (!(step.dot(gradient) < 0)) step = -a * a * gradient;
  const double greatest = step.cwiseAbs().maxCoeff();
  return greatest > a / 2 ? Vector2d(step * (a / 2 / greatest)) : step;
}

// Moves the edges until they stay; returns the number of steps.
int find_edges(const Profile& profile, const GivenEdges& contact, Edges& edges) {
  constexpr int max_iterations = 200;
  constexpr double settled = 1e-9;  // the next step would be 1e-5 of this one, which is rounding
  for (int iteration = 1; iteration <= max_iterations; ++iteration) {
    const Edges before = edges;
    const Vector2d step = newton_step(contact, before);
    const double tolerance = settled * (before.right - before.left);
    edges = moved(profile, before, step);
    if (step.cwiseAbs().maxCoeff() <= tolerance) return iteration;
    if (std::hypot(edges.left - before.left, edges.right - before.right) <= tolerance) {
      throw contact::ContactError(
          fmt::format("the contact reaches an end of the profile, which is given from {} to {}",
                      profile.begin(), profile.end()));
    }
  }
  throw contact::ContactError(
      fmt::format("the edges of contact did not settle in {} steps: {} and {}", max_iterations,
                  edges.left, edges.right));
}

// Refuses tension at the nodes, and penetration where the table of a measured profile goes on. The
// profiles with a formula are convex: between bodies pressed together at one place no other closes.
void require_one_region(const GradedSolution& solution, const Profile& profile, double total) {
  constexpr double noise =
      1e-4;  // so much of the peak, and of 2P/(πE*), is the error of discretisation on coarse grids
  const double least = solution.pressure.minCoeff();
  if (least < -noise * solution.peak_pressure()) {
    throw contact::ContactError(
        fmt::format("tension {} in contact: it has more than one region", -least));
  }
  if (!std::isfinite(profile.begin()) || !std::isfinite(profile.end())) return;
  const Index n = solution.bulge.size();
  for (Index i = 0; i < n; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(n);
    for (const double x : {profile.begin() + share * (solution.edges.left - profile.begin()),
                           profile.end() - share * (profile.end() - solution.edges.right)}) {
      if (profile.gap(x) - solution.approach(x) < -noise * total) {
        throw contact::ContactError(
            fmt::format("penetration at x = {}: contact has more than one region", x));
      }
    }
  }
}

void require_valid(double contact_modulus, double line_load, long n_elements, Edges start) {
  sys::require_positive("contact_modulus", contact_modulus);
  sys::require_positive("load", line_load);
  if (n_elements < min_graded_elements || n_elements > max_graded_elements) {
    throw sys::InvalidQuantity(
        "elements", static_cast<double>(n_elements),
        fmt::format("from {} to {}", min_graded_elements, max_graded_elements));
  }
  sys::require_finite("left edge", start.left);
  sys::require_finite("right edge", start.right);
}

}  // namespace

GradedSolution solve_on_graded_grid(const Profile& profile, double contact_modulus,
                                    double line_load, long n_elements, Edges start) {
  require_valid(contact_modulus, line_load, n_elements, start);
  Edges edges = moved(profile, start, Vector2d::Zero());
  if (!(edges.left < edges.right)) {
    throw sys::InvalidQuantity("left edge", start.left,
                               fmt::format("less than the right edge {}", start.right));
  }
  const double total = 2 * line_load / (pi * contact_modulus);
  const GivenEdges contact(profile, total, n_elements);
  const int n_iterations = find_edges(profile, contact, edges);

  // Turn the loads of nodes into stresses, and the differences of h into h
  const ReferenceGrid& grid = contact.grid();
  const Index n = grid.n_nodes();
  const VectorXd unknowns = contact.solve(edges);
  const double stress_per_length = pi * contact_modulus / (edges.right - edges.left);
  GradedSolution solution{.edges = edges,
                          .x = VectorXd::NullaryExpr(n, [&](Index i) { return grid.x(i, edges); }),
                          .pressure = stress_per_length * unknowns.head(n),
                          .bulge = {},
                          .contact_modulus = contact_modulus,
                          .approach_at_half_width = unknowns[n] + profile.gap(grid.x(n / 2, edges)),
                          .n_iterations = n_iterations,
                          .misfit = 0};
  solution.pressure[0] = solution.pressure[n - 1] = 0;
  solution.bulge = contact.bulge() * solution.pressure;
  for (const double x : solution.x) {
    solution.misfit = std::max(solution.misfit, std::abs(profile.gap(x) - solution.approach(x)));
  }
  require_one_region(solution, profile, total);
  return solution;
}

}  // namespace line_contact
