// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/solver/solution.hpp"

#include <boost/test/unit_test.hpp>
#include <vector>

#include "tolerances.hpp"

BOOST_AUTO_TEST_SUITE(regions_test)

using Eigen::Index;
using Eigen::VectorXd;
using point_contact::Element;
using point_contact::Grid;
using point_contact::hexagonal_grid;
using point_contact::Region;
using point_contact::regions;
using point_contact::Solution;
using point_contact::square_grid;
using point_contact::Vector2;
using tolerance::relative_difference;

namespace {

struct Disk {
  Vector2 centre;
  double radius;
  double pressure;
};

Solution pressed_on(const Grid& grid, const std::vector<Disk>& disks) {
  Solution solution{.grid = grid,
                    .element = Element::pyramid,
                    .pressure = VectorXd::Zero(grid.size()),
                    .gap = VectorXd::Zero(grid.size()),
                    .approach = 0,
                    .work = {},
                    .residuals = {}};
  for (Index j = 0; j < grid.n2; ++j) {
    for (Index i = 0; i < grid.n1; ++i) {
      for (const Disk& disk : disks) {
        if ((grid.node(i, j) - disk.centre).norm() > disk.radius) continue;
        solution.pressure[grid.index(i, j)] = disk.pressure;
      }
    }
  }
  return solution;
}

}  // namespace

BOOST_AUTO_TEST_CASE(three_disks_are_three_regions_and_the_greatest_load_is_first) {
  const std::vector<Disk> disks = {
      {{-0.5, -0.5}, 0.3, 1.7}, {{0.5, -0.4}, 0.2, 20}, {{0.1, 0.6}, 0.25, 0.3}};
  for (const Grid& grid : {square_grid(2, 80), hexagonal_grid(2, 80)}) {
    const Solution solution = pressed_on(grid, disks);
    const std::vector<Region> found = regions(solution);

    BOOST_TEST_REQUIRE(found.size() == 3U);
    BOOST_TEST((found[0].centre - disks[1].centre).norm() < 0.01);
    BOOST_TEST((found[1].centre - disks[0].centre).norm() < 0.01);
    BOOST_TEST((found[2].centre - disks[2].centre).norm() < 0.01);
    double load = 0;
    double area = 0;
    Index n_nodes = 0;
    for (const Region& region : found) {
      load += region.load;
      area += region.area;
      n_nodes += region.n_nodes;
    }
    BOOST_TEST(relative_difference(load, solution.load()) < 1e-13);
    BOOST_TEST(relative_difference(area, solution.contact_area()) < 1e-13);
    BOOST_TEST(n_nodes == solution.n_in_contact());
  }
}

BOOST_AUTO_TEST_CASE(a_ring_is_one_region_and_what_it_encloses_another) {
  for (const Grid& grid : {square_grid(2, 80), hexagonal_grid(2, 80)}) {
    Solution ring = pressed_on(grid, {{{0, 0}, 0.9, 1}, {{0, 0}, 0.6, 0}, {{0, 0}, 0.3, 5}});

    BOOST_TEST(regions(ring).size() == 2U);
  }
}

BOOST_AUTO_TEST_CASE(without_pressure_there_is_no_region) {
  BOOST_TEST(regions(pressed_on(square_grid(2, 20), {})).empty());
}

BOOST_AUTO_TEST_SUITE_END()
