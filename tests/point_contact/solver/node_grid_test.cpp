// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/solver/solution.hpp"

#include <boost/test/unit_test.hpp>
#include <cstdint>
#include <vector>

#include "tolerances.hpp"

BOOST_AUTO_TEST_SUITE(node_grid_test)

using Eigen::Index;
using Eigen::VectorXd;
using point_contact::cross;
using point_contact::Element;
using point_contact::Grid;
using point_contact::hexagonal_grid;
using point_contact::rectangular_grid;
using point_contact::Solution;
using point_contact::Vector2;

namespace {

Solution solution_on(const Grid& grid, Element element) {
  return {.grid = grid,
          .element = element,
          .pressure = VectorXd::LinSpaced(grid.size(), 0, 2.385),
          .gap = VectorXd::LinSpaced(grid.size(), 1, 0),
          .approach = 0,
          .work = {},
          .residuals = {}};
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_file_holds_every_node_with_its_pressure_and_gap) {
  const Solution solution = solution_on(hexagonal_grid(3, 12), Element::pyramid);
  const auto [points, n_corners, corners, fields] = node_grid(solution);
  BOOST_TEST_REQUIRE(fields.size() == 2U);
  BOOST_TEST(fields[0].name == "pressure");
  BOOST_TEST(fields[1].name == "gap");
  const std::vector<double>& pressure = fields[0].values;
  const std::vector<double>& gap = fields[1].values;
  const Grid& grid = solution.grid;

  BOOST_TEST_REQUIRE(points.size() == 3 * pressure.size());
  BOOST_TEST_REQUIRE(static_cast<Index>(pressure.size()) == grid.size());
  for (std::size_t k = 0; k < pressure.size(); ++k) {
    const auto node = static_cast<Index>(k);
    const Vector2 at = grid.node(node % grid.n1, node / grid.n1);
    BOOST_TEST(points[3 * k] == at.x());
    BOOST_TEST(points[3 * k + 1] == at.y());
    BOOST_TEST(points[3 * k + 2] == 0);
    BOOST_TEST(pressure[k] == solution.pressure[node]);
    BOOST_TEST(gap[k] == solution.gap[node]);
  }
}

BOOST_AUTO_TEST_CASE(the_cells_cover_what_lies_between_the_nodes_once) {
  const Grid square = rectangular_grid(3, 2, 12);
  const Grid hexagonal = hexagonal_grid(3, 12);
  // between the outermost nodes, staggered rows without the half nodes at their ends
  const double square_area = 3.0 * 2 * (11.0 / 12) * (11.0 / 12);
  const double hexagonal_area =
      hexagonal.lattice.cell_area() * static_cast<double>((hexagonal.n1 - 1) * (hexagonal.n2 - 1));
  for (const auto& [grid, element, n_corners, area] :
       {std::tuple{square, Element::uniform, std::size_t{4}, square_area},
        {square, Element::pyramid, std::size_t{3}, square_area},
        {hexagonal, Element::pyramid, std::size_t{3}, hexagonal_area}}) {
    const numerics::UnstructuredGrid cells = node_grid(solution_on(grid, element));
    const std::vector<std::int64_t>& corners = cells.corners;
    BOOST_TEST(static_cast<std::size_t>(cells.n_corners) == n_corners);
    BOOST_TEST_REQUIRE(corners.size() % n_corners == 0U);
    double sum = 0;
    for (std::size_t cell = 0; cell < corners.size() / n_corners; ++cell) {
      const auto at = [&](std::size_t k) {
        const Index node = corners[cell * n_corners + k];
        return grid.node(node % grid.n1, node / grid.n1);
      };
      double twice = 0;
      for (std::size_t k = 1; k + 1 < n_corners; ++k) {
        const double part = cross(at(k) - at(0), at(k + 1) - at(0));
        BOOST_TEST(part > 0);  // counter-clockwise
        twice += part;
      }
      sum += twice / 2;
    }
    BOOST_TEST(tolerance::relative_difference(sum, area) < 1e-12);
  }
}

BOOST_AUTO_TEST_CASE(shear_stands_beside_the_pressure) {
  const Solution solution = solution_on(rectangular_grid(3, 2, 12), Element::uniform);
  const VectorXd shear = 0.3 * solution.pressure;
  const numerics::UnstructuredGrid::Field field = node_grid(solution, shear).fields.back();

  BOOST_TEST(field.name == "shear");
  BOOST_TEST_REQUIRE(field.values.size() == 144U);
  BOOST_TEST(field.values[77] == shear[77]);
}

BOOST_AUTO_TEST_SUITE_END()
