// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_contact/nested_grids.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <initializer_list>

#include "tolerances.hpp"

BOOST_AUTO_TEST_SUITE(prolongation_test)

using Eigen::Index;
using Eigen::VectorXd;
using line_contact::Grid;
using line_contact::grid_of_width;
using line_contact::prolongate;

namespace {

VectorXd vector(std::initializer_list<double> values) {
  VectorXd result(static_cast<Index>(values.size()));
  std::copy(values.begin(), values.end(), result.begin());
  return result;
}

template <class Function>
VectorXd sampled(const Grid& grid, const Function& function) {
  return grid.nodes().unaryExpr(function);
}

const auto ellipse = [](double x) {
  const double t = (x - 0.2385) / 0.83;
  return std::sqrt(std::max(0., 1 - t * t));
};

struct Errors {
  double inside, anywhere;
};

// Of an ellipse brought from n to 2n nodes.
Errors errors_of_ellipse(Index n) {
  const Grid coarse = grid_of_width(2.385, n, 0.2);
  const Grid fine = grid_of_width(2.385, 2 * n, 0.2);
  const VectorXd error =
      prolongate(coarse, sampled(coarse, ellipse), fine) - sampled(fine, ellipse);
  double inside = 0;
  for (Index i = 0; i < fine.n_nodes; ++i) {
    if (std::abs(fine.x(i) - 0.2385) < 0.4) inside = std::max(inside, std::abs(error[i]));
  }
  return {inside, error.cwiseAbs().maxCoeff()};
}

}  // namespace

BOOST_AUTO_TEST_CASE(at_the_coarse_nodes_the_pressure_stays_what_it_is) {
  const Grid grid = grid_of_width(2.385, 8, 0.7);
  const VectorXd pressure = vector({0, 1, 2, 2.385, 1.7, 0.6, 0, 0});

  BOOST_TEST((prolongate(grid, pressure, grid) - pressure).cwiseAbs().maxCoeff() <
             tolerance::rounding);
}

BOOST_AUTO_TEST_CASE(between_four_nodes_in_contact_it_is_their_cubic) {
  const Grid coarse = grid_of_width(2, 16, 0.3);
  const Grid fine = grid_of_width(2, 97, 0.3);
  const auto cubic = [](double x) { return 5 + x * (2.385 + x * (1.1 - 0.7 * x)); };
  const VectorXd result = prolongate(coarse, sampled(coarse, cubic), fine);

  int n_inside = 0;
  for (Index i = 0; i < fine.n_nodes; ++i) {
    if (fine.x(i) < coarse.x(1) || fine.x(i) > coarse.x(14)) continue;
    BOOST_TEST(tolerance::relative_difference(result[i], cubic(fine.x(i))) < tolerance::rounding);
    ++n_inside;
  }
  BOOST_TEST(n_inside > 75);
}

BOOST_AUTO_TEST_CASE(next_to_the_edge_it_is_linear) {
  // Contact at the nodes 0, 1 and 2, at x = −1, 0 and 1: of no pair both neighbours carry.
  const Grid coarse{5, 1, 1};
  const VectorXd pressure = vector({3, 2.385, 1, 0, 0});
  const Grid fine{9, 0.5, 1};
  const VectorXd result = prolongate(coarse, pressure, fine);

  BOOST_TEST(tolerance::relative_difference(result[1], (3 + 2.385) / 2) < 1e-15);
  BOOST_TEST(tolerance::relative_difference(result[3], (2.385 + 1) / 2) < 1e-15);
}

BOOST_AUTO_TEST_CASE(a_neighbour_out_of_contact_makes_it_linear_on_its_side_alone) {
  const Grid coarse{7, 1};
  const VectorXd pressure = vector({0, 1, 2, 4, 3, 1, 0});
  const VectorXd result = prolongate(coarse, pressure, Grid{13, 0.5});

  BOOST_TEST(tolerance::relative_difference(result[3], 1.5) < 1e-15);
  // (−p₁ + 9p₂ + 9p₃ − p₄)/16, Lagrange's cubic halfway
  BOOST_TEST(tolerance::relative_difference(result[5], (-1 + 9 * 2 + 9 * 4 - 3) / 16.) < 1e-15);
  BOOST_TEST(tolerance::relative_difference(result[7], (-2 + 9 * 4 + 9 * 3 - 1) / 16.) < 1e-15);
  BOOST_TEST(tolerance::relative_difference(result[9], 2) < 1e-15);
}

BOOST_AUTO_TEST_CASE(towards_the_edge_its_square_falls_linearly) {
  // p² = 1 at x = 1, 3 at x = 0: zero at x = 1½.
  const Grid coarse{5, 1};
  const VectorXd pressure = vector({0, 0, std::sqrt(3.), 1, 0});
  const Grid fine{33, 0.125};
  const VectorXd result = prolongate(coarse, pressure, fine);

  for (Index i = 24; i <= 28; ++i) {
    BOOST_TEST(std::abs(result[i] * result[i] - (1.5 - fine.x(i)) / 0.5) < 1e-14);
  }
  BOOST_TEST(result[27] > 0.4);
  BOOST_TEST(result.tail(4).cwiseAbs().maxCoeff() == 0);
}

BOOST_AUTO_TEST_CASE(both_edges_are_treated_alike) {
  const Grid coarse = grid_of_width(1, 9);
  const Grid fine = grid_of_width(1, 70);
  const VectorXd pressure = vector({0, 0.3, 1, 2, 1.1, 0, 2.385, 0.4, 0});
  const VectorXd mirrored = pressure.reverse();

  BOOST_TEST((prolongate(coarse, pressure, fine) - prolongate(coarse, mirrored, fine).reverse())
                 .cwiseAbs()
                 .maxCoeff() < 1e-13);
}

BOOST_AUTO_TEST_CASE(an_ellipse_is_kept_to_order_four_inside_and_to_one_half_at_the_edge) {
  const int n_halvings = 5;
  const Errors first = errors_of_ellipse(60);
  const Errors last = errors_of_ellipse(60 << n_halvings);
  const double inside = std::log2(first.inside / last.inside) / n_halvings;
  const double anywhere = std::log2(first.anywhere / last.anywhere) / n_halvings;

  BOOST_TEST(std::abs(inside - 4) < 0.2);
  BOOST_TEST(std::abs(anywhere - 0.5) < 0.2);  // single grids scatter with where the edge falls
}

BOOST_AUTO_TEST_CASE(regions_stay_apart) {
  const Grid coarse{9, 1};
  const VectorXd pressure = vector({0, 1, 0, 0, 2, 3, 2, 0, 0});
  const VectorXd result = prolongate(coarse, pressure, Grid{33, 0.25});

  BOOST_TEST(result[4] == 1);
  BOOST_TEST(result.segment(7, 5).cwiseAbs().maxCoeff() == 0);
  BOOST_TEST(result[20] == 3);
}

BOOST_AUTO_TEST_CASE(a_single_node_spreads_over_its_spacing) {
  // Zero c/2 from the node, p√½ halfway there.
  const VectorXd result = prolongate({5, 1}, vector({0, 0, 2.385, 0, 0}), {17, 0.25});

  BOOST_TEST(result[8] == 2.385);
  BOOST_TEST(tolerance::relative_difference(result[7], 2.385 * std::sqrt(0.5)) < 1e-15);
  BOOST_TEST(tolerance::relative_difference(result[9], 2.385 * std::sqrt(0.5)) < 1e-15);
  BOOST_TEST(result[6] == 0);
  BOOST_TEST(result[10] == 0);
}

BOOST_AUTO_TEST_CASE(contact_may_reach_both_ends_of_the_grid) {
  const Grid coarse = grid_of_width(2.385, 6);
  const Grid fine = grid_of_width(2.385, 12);
  const VectorXd result = prolongate(coarse, VectorXd::Constant(6, 1.7), fine);

  BOOST_TEST(result.size() == 12);
  BOOST_TEST(result.segment(1, 10).minCoeff() > 1.7 - 1e-14);
  BOOST_TEST(result.maxCoeff() < 1.7 + 1e-14);
  BOOST_TEST(tolerance::relative_difference(result[0], 1.7 * std::sqrt(0.5)) < 1e-14);
  BOOST_TEST(tolerance::relative_difference(result[11], 1.7 * std::sqrt(0.5)) < 1e-14);
}

BOOST_AUTO_TEST_CASE(a_node_that_touches_without_carrying_does_no_harm) {
  // Its square is zero in double precision: the edge lies at the node.
  for (const Index n_fine : {7, 8, 13, 14}) {
    const VectorXd right =
        prolongate({7, 1}, vector({0, 0, 1, 2, 1e-300, 0, 0}), grid_of_width(7, n_fine));
    const VectorXd left =
        prolongate({7, 1}, vector({0, 0, 1e-300, 2, 1, 0, 0}), grid_of_width(7, n_fine));

    BOOST_TEST(right.allFinite());
    BOOST_TEST(left.allFinite());
    BOOST_TEST(right.minCoeff() >= 0);
    BOOST_TEST((right - left.reverse()).cwiseAbs().maxCoeff() < 1e-14);
  }
}

BOOST_AUTO_TEST_CASE(no_contact_stays_none) {
  BOOST_TEST(prolongate({5, 1}, VectorXd::Zero(5), {11, 0.4}).cwiseAbs().maxCoeff() == 0);
}

BOOST_AUTO_TEST_SUITE_END()
