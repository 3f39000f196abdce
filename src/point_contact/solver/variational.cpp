// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/solver/variational.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "line_contact/contact_error.hpp"
#include "point_contact/solver/fft_solver.hpp"
#include "system/require.hpp"

namespace point_contact {
namespace {

using Eigen::ArrayXd;
using Eigen::VectorXd;
using Carrying = Eigen::Array<bool, Eigen::Dynamic, 1>;

double mean_where(const Carrying& carrying, const VectorXd& values) {
  return carrying.select(values.array(), 0).sum() / static_cast<double>(carrying.count());
}

// Steps along conjugate directions on the nodes that carry; a node that would be in tension is set
// to zero, one without pressure that penetrates begins to carry, and the load is made P again.
ElementLoads minimise(InfluenceOperator& influence, const VectorXd& gaps, double total,
                      double tolerance) {
  constexpr int max_products = 20'000;
  const Carrying is_body = gaps.array() < largest_length;
  ElementLoads loads;
  VectorXd& phi = loads.phi;
  VectorXd& gap = loads.gap;
  phi = is_body.select(
      VectorXd::Constant(gaps.size(), total / static_cast<double>(is_body.count())), 0);
  VectorXd direction = VectorXd::Zero(gaps.size());
  VectorXd change(gaps.size());
  double previous = 1;
  bool is_conjugate = false;
  for (int products = 1; products < max_products; products += 2) {
    // g = Tφ + h − δ with the mean 0 where φ > 0
    influence.displacements(phi, gap);
    gap += gaps;
    const Carrying carrying = phi.array() > 0;
    loads.approach = mean_where(carrying, gap);
    gap.array() -= loads.approach;

    const double misfit = carrying.select(gap.array().abs(), -gap.array()).maxCoeff();
    loads.error = misfit / phi.maxCoeff();
    loads.work = {.iterations = products / 2, .products = products};
    if (loads.error <= tolerance) return loads;

    // t = g + β t, β = (g, g)/(g, g)_old
    const double square = carrying.select(gap.array().square(), 0).sum();
    const double factor = is_conjugate ? square / previous : 0;
    direction = carrying.select(gap.array() + factor * direction.array(), 0);
    previous = square;

    // φ −= τ t, τ = (g, t)/(r, t), r = Tt without its mean
    influence.displacements(direction, change);
    change.array() -= mean_where(carrying, change);
    const double along = carrying.select(gap.array() * direction.array(), 0).sum();
    const double step = along / direction.dot(change);
    phi = (phi - step * direction).cwiseMax(0);

    const Carrying enters = phi.array() == 0 && gap.array() < 0;
    is_conjugate = !enters.any();
    phi = enters.select(-step * gap, phi);
    phi *= total / phi.sum();
  }
  throw line_contact::ContactError(
      fmt::format("the variational method did not reach its minimum in {} products", max_products));
}

}  // namespace

Solution solve_by_variational_method(const Problem& problem, double load,
                                     const Accuracy& accuracy) {
  const double total = total_phi(problem, load);
  require_tolerance(accuracy.tolerance);
  const RowTeam team(accuracy.n_threads);
  const VectorXd gaps = initial_gaps(problem, team);
  InfluenceOperator influence(ElementPotential(problem.element, problem.grid.lattice), problem.grid,
                              team);
  ElementLoads loads = minimise(influence, gaps, total, accuracy.tolerance);
  require_free_ends(problem, loads.phi, Control::load, load);
  return to_solution(problem, load, std::move(loads));
}

}  // namespace point_contact
