// SPDX-License-Identifier: GPL-3.0-or-later
// A row of springs, each of which also displaces its neighbours: no bodies, only equations.
#include "contact/reference_methods.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "contact/contact_search.hpp"
#include "messages.hpp"

BOOST_AUTO_TEST_SUITE(reference_methods_test)

using contact::ContactLoads;
using contact::Equations;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

constexpr Index n = 41;

double displacement(Index i, Index j) {
  return std::exp(-0.2385 * std::abs(static_cast<double>(i - j)));
}

double influence(Index i, Index j) {
  return -displacement(i, j);
}

Equations parabola(double total) {
  VectorXd gap = VectorXd::LinSpaced(n, 0, n - 1);
  gap = 0.00571 * (gap.array() - 17.3).square();
  return {gap, total, 1e-13};
}

ContactLoads minimised(const Equations& equations, int max_products = 5000) {
  const MatrixXd matrix =
      MatrixXd::NullaryExpr(n, n, [](Index i, Index j) { return displacement(i, j); });
  return contact::minimise(
      equations, [&](const VectorXd& phi, VectorXd& u) { u = matrix * phi; }, 0, max_products);
}

}  // namespace

BOOST_AUTO_TEST_CASE(each_node_has_a_load_or_a_gap_and_the_loads_sum_to_the_total) {
  for (const double total : {0.01, 1.385, 40.0}) {
    const Equations equations = parabola(total);
    for (const ContactLoads& loads : {invert(equations, influence), minimised(equations)}) {
      BOOST_TEST(std::abs(loads.phi.sum() - total) < 1e-12 * total);
      for (Index i = 0; i < n; ++i) {
        double gap = equations.initial_gap[i] - loads.approach;
        for (Index j = 0; j < n; ++j) gap += displacement(i, j) * loads.phi[j];
        BOOST_TEST(loads.phi[i] >= 0);
        BOOST_TEST(std::abs(gap - loads.gap[i]) <= 1e-12 * std::max(1., gap));
        if (loads.phi[i] > 0) {
          BOOST_TEST(std::abs(gap) < 1e-12);
        } else {
          BOOST_TEST(gap > -1e-12);
        }
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(
    both_methods_find_the_same_solution_though_one_never_searches_for_the_contact) {
  const Equations equations = parabola(1.385);
  const ContactLoads inverted = invert(equations, influence);
  const ContactLoads least = minimised(equations);

  BOOST_TEST((inverted.phi - least.phi).cwiseAbs().maxCoeff() < 1e-10 * inverted.phi.maxCoeff());
  BOOST_TEST(std::abs(inverted.approach - least.approach) < 1e-11 * inverted.approach);
  BOOST_TEST(inverted.solves > 1);
  BOOST_TEST(least.products > 2);
}

BOOST_AUTO_TEST_CASE(a_minimum_out_of_reach_is_an_error_with_the_number_of_products) {
  BOOST_TEST(
      message_of<contact::ContactError>([] { minimised(parabola(1.385), 4); }) ==
      "the computation failed: the variational method did not reach its minimum in 4 products");
}

BOOST_AUTO_TEST_SUITE_END()
