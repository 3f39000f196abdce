// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/solver/grid.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>
#include <utility>

#include "system/require.hpp"
#include "tolerances.hpp"

BOOST_AUTO_TEST_SUITE(grid_test)

using Eigen::Index;
using point_contact::Grid;
using point_contact::hexagonal_grid;
using point_contact::rectangular_grid;
using point_contact::square_grid;
using point_contact::Vector2;
using sys::InvalidQuantity;
using tolerance::relative_difference;

BOOST_AUTO_TEST_CASE(nodes_lie_in_the_middle_of_their_cells) {
  const Grid grid = rectangular_grid(2, 0.6, 10);

  BOOST_TEST((grid.node(Index{0}, Index{0}) - Vector2(-0.9, -0.27)).norm() < 1e-15);
  BOOST_TEST((grid.node(Index{9}, Index{9}) - Vector2(0.9, 0.27)).norm() < 1e-15);
  BOOST_TEST(relative_difference(grid.lattice.cell_area() * 100, 1.2) < 1e-14);
  BOOST_TEST(grid.index(3, 2) == 23);
  BOOST_TEST(grid.size() == 100);
}

BOOST_AUTO_TEST_CASE(a_hexagonal_grid_has_six_nearest_neighbours) {
  const Grid grid = hexagonal_grid(3, 30);
  for (const Index j : {10, 11}) {
    const Vector2 here = grid.node(10, j);
    for (const auto& [di, dj] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {-1, 1}, {1, -1}}) {
      const Vector2 there = grid.node(grid.neighbour(10, j, di, dj), j + dj);
      BOOST_TEST(relative_difference((there - here).norm(), 0.1) < 1e-13);
      BOOST_TEST((there - here - di * grid.lattice.first - dj * grid.lattice.second).norm() <
                 1e-14);
    }
  }
  BOOST_TEST(relative_difference(grid.spacing(), 0.1 * std::sqrt(std::sqrt(3.0) / 2)) < 1e-14);
}

BOOST_AUTO_TEST_CASE(a_hexagonal_grid_fills_the_square) {
  for (const Index n : {30, 31, 64}) {
    const Grid grid = hexagonal_grid(3, n);
    const double side = 3.0 / static_cast<double>(n);
    // the middles of the first and the last two rows' first and last nodes
    const Vector2 low = (grid.node(0, 0) + grid.node(0, 1)) / 2;
    const Vector2 high = (grid.node(n - 1, grid.n2 - 1) + grid.node(n - 1, grid.n2 - 2)) / 2;
    BOOST_TEST(relative_difference(high.x() - low.x() + side, 3) < 1e-14);
    const double height = static_cast<double>(grid.n2) * grid.lattice.second.y();
    BOOST_TEST(height >= 3);
    BOOST_TEST(height < 3 + side);
    const Vector2 corners = grid.node(0, 0) + grid.node(n - 1, grid.n2 - 1);
    BOOST_TEST(std::abs(corners.y()) < 1e-14);
  }
}

BOOST_AUTO_TEST_CASE(a_domain_keeps_its_size_with_other_numbers_of_nodes) {
  for (const Grid& grid : {hexagonal_grid(3, 30), rectangular_grid(2, 0.6, 30)}) {
    const Grid other = grid.with_nodes(13, 11);
    BOOST_TEST(relative_difference(13 * other.lattice.first.x(), 30 * grid.lattice.first.x()) <
               1e-14);
    BOOST_TEST(relative_difference(11 * other.between_rows().y(),
                                   static_cast<double>(grid.n2) * grid.between_rows().y()) < 1e-14);
    BOOST_TEST(std::abs(other.between_rows().x()) < 1e-15);
    BOOST_TEST(other.is_staggered == grid.is_staggered);
  }
}

BOOST_AUTO_TEST_CASE(a_stretched_grid_is_so_many_times_as_high) {
  const Grid grid = hexagonal_grid(3, 30);
  const Grid flat = hexagonal_grid(3, 30, 0.2);
  const Vector2 corner = grid.node(29, 29);

  BOOST_TEST((flat.node(29, 29) - Vector2(corner.x(), 0.2 * corner.y())).norm() < 1e-14);
}

BOOST_AUTO_TEST_CASE(bad_grids_are_refused) {
  BOOST_CHECK_THROW(square_grid(0, 100), InvalidQuantity);
  BOOST_CHECK_THROW(square_grid(1, 7), InvalidQuantity);
  BOOST_CHECK_THROW(rectangular_grid(1, -1, 100), InvalidQuantity);
  BOOST_CHECK_THROW(hexagonal_grid(std::nan(""), 100), InvalidQuantity);
  BOOST_CHECK_THROW(hexagonal_grid(1, 100, 0), InvalidQuantity);
}

BOOST_AUTO_TEST_SUITE_END()
