// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_contact/variational.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "line_contact/contact_error.hpp"
#include "line_contact/dense_system.hpp"
#include "line_contact/free_ends.hpp"

namespace line_contact {
namespace {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd compliance_of(const DenseSystem& system) {
  return MatrixXd::NullaryExpr(system.size(), system.size(),
                               [&](Index i, Index j) { return -system.coefficient(i, j); });
}

// Returns the mean over the nodes in contact, in which a node with a mirror image counts twice.
double mean_in_contact(const VectorXd& values, const ArrayXd& weight_in_contact) {
  return (weight_in_contact * values.array()).sum() / weight_in_contact.sum();
}

struct Minimum {
  VectorXd phi;
  VectorXd gap;
  double approach;
  int products;
};

// begin excerpt: variational
// Steps along conjugate directions on the nodes that carry; a node that would be in tension is set
// to zero, one without pressure that penetrates begins to carry, and the load is made P again.
Minimum minimise(const DenseSystem& system, double smallest_gap, int max_products) {
  const MatrixXd compliance = compliance_of(system);
  VectorXd phi = VectorXd::Constant(system.size(), system.total() / system.weights().sum());
  VectorXd direction = VectorXd::Zero(system.size());
  double previous = 1;
  bool is_conjugate = false;
  for (int products = 1; products < max_products; products += 2) {
    // Compute the gap, the gradient of the energy: g = C φ + h − δ, ⟨g⟩ = 0 where φ > 0
    VectorXd gap = compliance * phi + system.initial_gap();
    const ArrayXd carrying = (phi.array() > 0).select(system.weights().array(), 0);
    const double approach = mean_in_contact(gap, carrying);
    gap.array() -= approach;

    const double misfit = (carrying > 0).select(gap.array().abs(), -gap.array()).maxCoeff();
    if (misfit <= smallest_gap) return {std::move(phi), std::move(gap), approach, products};

    // Step along the next conjugate direction, and take tension away
    const double square = (carrying * gap.array().square()).sum();   // ρ = (g, g)
    const double factor = is_conjugate ? square / previous : 0;      // β = ρ / ρ_old
    direction = (carrying > 0).select(gap + factor * direction, 0);  // d = g + β d
    previous = square;
    VectorXd change = compliance * direction;
    change.array() -= mean_in_contact(change, carrying);  // q = C d − ⟨C d⟩
    const ArrayXd weighted = carrying * direction.array();
    const double step =
        weighted.matrix().dot(gap) / weighted.matrix().dot(change);  // α = (d,g)/(d,q)
    phi = (phi - step * direction).cwiseMax(0);                      // φ = max(φ − α d, 0)

    // Let nodes that penetrate begin to carry, φ = −α g; the directions then start again
    is_conjugate = true;
    for (Index i = 0; i < phi.size(); ++i) {
      if (phi[i] > 0 || gap[i] >= 0) continue;
      phi[i] = -step * gap[i];
      is_conjugate = false;
    }
    phi *= system.total() / system.weights().dot(phi);  // Σ w φ = 2P/(πE*)
  }
  throw ContactError(
      fmt::format("the variational method did not reach its minimum in {} products", max_products));
}
// end excerpt: variational

}  // namespace

Solution solve_by_variational_method(const Problem& problem, double line_load) {
  const DenseSystem system(problem, line_load);
  const int max_products = 1000 + static_cast<int>(400 * std::sqrt(system.size()));
  Minimum minimum = minimise(system, system.rounding_of_gap(), max_products);
  require_free_ends(problem, minimum.phi, line_load);

  double misfit = 0;
  for (Index i = 0; i < system.size(); ++i) {
    if (minimum.phi[i] > 0) misfit = std::max(misfit, std::abs(minimum.gap[i]));
  }
  const double error = misfit / minimum.phi.maxCoeff();
  return to_solution(
      problem, line_load,
      {std::move(minimum.phi), std::move(minimum.gap), minimum.approach + system.least_gap(), error,
       Work{.iterations = minimum.products / 2, .products = minimum.products}});
}

}  // namespace line_contact
