// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/solver/problem.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>
#include <utility>

#include "system/require.hpp"
#include "tolerances.hpp"

BOOST_AUTO_TEST_SUITE(problem_test)

BOOST_AUTO_TEST_SUITE(grid)

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

using Eigen::Index;
using point_contact::initial_gaps;
using point_contact::Problem;
using point_contact::Profile;
using point_contact::RowTeam;
using point_contact::square_grid;
using sys::InvalidQuantity;

BOOST_AUTO_TEST_CASE(initial_gaps_are_those_of_the_profile_at_the_nodes) {
  const Problem problem{Profile::elliptic_paraboloid(0.3, 2), 1, square_grid(1, 12)};
  const Eigen::VectorXd gaps = initial_gaps(problem, RowTeam(2));
  for (const auto& [i, j] : {std::pair<Index, Index>{0, 0}, {3, 7}, {11, 2}}) {
    BOOST_TEST(gaps[problem.grid.index(i, j)] == problem.profile.gap(problem.grid.node(i, j)));
  }
}

BOOST_AUTO_TEST_CASE(a_grid_beyond_the_measured_surface_is_refused) {
  const Profile map = Profile::height_map(Eigen::ArrayXXd::Zero(11, 11), 0.1);
  BOOST_CHECK_NO_THROW(initial_gaps({map, 1, square_grid(1, 20)}, RowTeam(1)));
  BOOST_CHECK_EXCEPTION(initial_gaps({map, 1, square_grid(1.2, 20)}, RowTeam(1)), InvalidQuantity,
                        [](const InvalidQuantity& error) {
                          return error.allowed().find("measured surface") != std::string::npos;
                        });
}

BOOST_AUTO_TEST_CASE(bodies_without_modulus_or_extent_are_refused) {
  BOOST_CHECK_THROW(initial_gaps({Profile::paraboloid(1), 0, square_grid(1, 20)}, RowTeam(1)),
                    InvalidQuantity);
  // a punch between the nodes
  BOOST_CHECK_THROW(initial_gaps({Profile::flat_punch(1e-3), 1, square_grid(1, 20)}, RowTeam(1)),
                    InvalidQuantity);
  BOOST_CHECK_THROW(initial_gaps({Profile::paraboloid(1e300), 1, square_grid(1, 20)}, RowTeam(1)),
                    InvalidQuantity);
}

BOOST_AUTO_TEST_SUITE(memory)

using Eigen::Index;
using point_contact::require_memory;
using sys::InvalidQuantity;

BOOST_AUTO_TEST_CASE(memory_that_is_not_there_is_told_before_it_is_asked_for) {
  BOOST_CHECK_NO_THROW(require_memory(1024, 1024));
  BOOST_CHECK_EXCEPTION(require_memory(2'000'000, 2'000'000), InvalidQuantity,
                        [](const InvalidQuantity& error) {
                          return error.quantity() == "nodes" &&
                                 error.allowed().find("GB of memory") != std::string::npos;
                        });
  BOOST_CHECK_THROW(require_memory(Index{1} << 40, Index{1} << 40), InvalidQuantity);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE_END()
