// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/projected_cg.hpp"

#include <Eigen/LU>
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "point_contact/cases.hpp"

BOOST_AUTO_TEST_SUITE(projected_cg_test)

using namespace point_cases;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using point_contact::ContactState;
using point_contact::InfluenceOperator;
using point_contact::ProjectedCg;

namespace {

constexpr Index n1 = 17, n2 = 14, n = n1 * n2;

// A paraboloid with contact fixed on a disk with a hole and on a single node, under Σφ = 2.385.
ContactState held(InfluenceOperator& influence, VectorXd& initial_gap) {
  initial_gap = VectorXd::NullaryExpr(n, [](Index k) {
    const double x = static_cast<double>(k % n1) - 7.7, y = static_cast<double>(k / n1) - 6.1;
    return 0.02385 * (x * x + y * y);
  });
  ContactState state;
  state.in_contact = initial_gap.array() < 0.6;
  state.in_contact[6 * n1 + 8] = false;
  state.in_contact[0] = true;
  state.phi = state.in_contact.cast<double>().matrix();
  state.phi *= 2.385 / state.phi.sum();
  influence.displacements(state.phi, state.gap);
  state.gap += initial_gap;
  return state;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_fixed_contact_is_solved_as_by_elimination) {
  for (const Element element : elements) {
    InfluenceOperator influence(element, n1, n2);
    VectorXd initial_gap;
    ContactState state = held(influence, initial_gap);
    ProjectedCg gradients(influence);
    gradients.start(state);
    int n_steps = 0;
    for (; n_steps < 60 && gradients.error() > 1e-13; ++n_steps) gradients.step();

    // Eq. (1a) at the nodes in contact and Σφ by Gaussian elimination.
    MatrixXd matrix = MatrixXd::Zero(n + 1, n + 1);
    VectorXd right_side = VectorXd::Zero(n + 1);
    for (Index i = 0; i < n; ++i) {
      matrix(i, i) = 1;
      if (!state.in_contact[i]) continue;
      for (Index j = 0; j < n; ++j) {
        matrix(i, j) = influence_coefficient(
            element, {static_cast<double>(i % n1 - j % n1), static_cast<double>(i / n1 - j / n1)});
      }
      matrix(i, n) = -1;
      matrix(n, i) = 1;
      right_side[i] = -initial_gap[i];
    }
    right_side[n] = 2.385;
    const VectorXd exact = matrix.partialPivLu().solve(right_side);

    BOOST_TEST((state.phi - exact.head(n)).cwiseAbs().maxCoeff() < 1e-11 * exact.maxCoeff());
    BOOST_TEST(std::abs(state.approach - exact[n]) < 1e-11 * exact[n]);
    BOOST_TEST(state.in_contact.select(state.gap.array(), 0).abs().maxCoeff() < 1e-11 * exact[n]);
    BOOST_TEST(n_steps < 45);
    BOOST_TEST(gradients.work().products == n_steps);
    BOOST_TEST(gradients.work().preconditionings == n_steps + 2);
  }
}

BOOST_AUTO_TEST_SUITE_END()
