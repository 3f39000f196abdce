// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/solver/methods.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

BOOST_AUTO_TEST_SUITE(prolongation_test)

using Eigen::Index;
using Eigen::VectorXd;
using point_contact::Grid;
using point_contact::hexagonal_grid;
using point_contact::prolongate;
using point_contact::square_grid;

namespace {

// The pressure of spheres on the nodes of a grid, p₀ = 1.
VectorXd hertz(const Grid& grid, double a) {
  VectorXd pressure(grid.size());
  for (Index j = 0; j < grid.n2; ++j) {
    for (Index i = 0; i < grid.n1; ++i) {
      const double rho = grid.node(i, j).norm() / a;
      pressure[grid.index(i, j)] = rho < 1 ? std::sqrt(1 - rho * rho) : 0;
    }
  }
  return pressure;
}

// How many nodes are in contact in one and not in the other.
Index n_different(const VectorXd& one, const VectorXd& other) {
  return ((one.array() > 0) != (other.array() > 0)).count();
}

}  // namespace

BOOST_AUTO_TEST_CASE(hertzs_pressure_is_prolongated_to_the_square_of_the_spacing) {
  for (const Index n : {32, 64}) {
    const Grid coarse = square_grid(2, n);
    const Grid fine = square_grid(2, 2 * n);
    const VectorXd exact = hertz(fine, 0.8);
    const VectorXd result = prolongate(coarse, hertz(coarse, 0.8), fine);
    const double spacing = coarse.spacing() / 0.8;
    // Of p² = 1 − r²/a², whose second derivative is 2/a²: interpolation leaves (c²/8)·(2/a²) along
    // x and along y, and the straight lines across the edge up to (√2 c)²·(2/a²) along a diagonal.
    const auto error = (result.array().square() - exact.array().square()).abs();
    BOOST_TEST(error.maxCoeff() < 4 * spacing * spacing);
    const auto deep_inside = exact.array() > 0.5;
    BOOST_TEST(deep_inside.select(error, 0).maxCoeff() < 0.51 * spacing * spacing);
  }
}

BOOST_AUTO_TEST_CASE(the_edge_of_the_contact_keeps_its_place_between_the_coarse_nodes) {
  for (const double a : {0.71, 0.723, 0.738}) {
    const Grid coarse = hexagonal_grid(2, 64);
    const Grid fine = hexagonal_grid(2, 128);
    const VectorXd exact = hertz(fine, a);
    const VectorXd result = prolongate(coarse, hertz(coarse, a), fine);
    // less than a tenth of the nodes along the edge
    const double n_along_edge = 2 * std::numbers::pi * a / fine.spacing();
    BOOST_TEST(static_cast<double>(n_different(result, exact)) < n_along_edge / 10);
  }
}

BOOST_AUTO_TEST_CASE(grids_need_not_be_twice_as_fine) {
  const Grid coarse = square_grid(2, 33);
  const Grid fine = square_grid(2, 65);
  const VectorXd exact = hertz(fine, 0.8);
  const VectorXd result = prolongate(coarse, hertz(coarse, 0.8), fine);

  BOOST_TEST((result - exact).array().square().maxCoeff() < 5e-3);
}

BOOST_AUTO_TEST_CASE(no_contact_stays_none_and_full_contact_full) {
  const Grid coarse = square_grid(1, 16);
  const Grid fine = square_grid(1, 32);

  BOOST_TEST((prolongate(coarse, VectorXd::Zero(256), fine).array() == 0).all());
  BOOST_TEST((prolongate(coarse, VectorXd::Ones(256), fine).array() - 1).abs().maxCoeff() < 1e-15);
}

BOOST_AUTO_TEST_SUITE_END()
