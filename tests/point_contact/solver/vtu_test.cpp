// SPDX-License-Identifier: GPL-3.0-or-later
// The file is read back by its own header: attributes from the XML, numbers from the appended data.
#include "point_contact/solver/solution.hpp"

#include <boost/test/unit_test.hpp>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "tolerances.hpp"

BOOST_AUTO_TEST_SUITE(vtu_test)

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

// The text between two others.
std::string between(const std::string& text, const std::string& before, const std::string& after) {
  const std::size_t begin = text.find(before);
  BOOST_TEST_REQUIRE((begin != std::string::npos), before);
  const std::size_t from = begin + before.size();
  return text.substr(from, text.find(after, from) - from);
}

// The numbers of the array whose element holds `attribute`.
template <class Number>
std::vector<Number> array_of(const std::string& file, const std::string& attribute) {
  const std::size_t offset =
      std::stoul(between(file.substr(file.find(attribute)), "offset=\"", "\""));
  const char* data = file.data() + file.find("\n_") + 2 + offset;
  std::uint64_t n_bytes = 0;
  std::memcpy(&n_bytes, data, sizeof n_bytes);
  std::vector<Number> numbers(n_bytes / sizeof(Number));
  std::memcpy(numbers.data(), data + sizeof n_bytes, n_bytes);
  return numbers;
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_file_holds_every_node_with_its_pressure_and_gap) {
  const Solution solution = solution_on(hexagonal_grid(3, 12), Element::pyramid);
  const std::string file = vtu(solution);
  const auto points = array_of<double>(file, "NumberOfComponents=\"3\"");
  const auto pressure = array_of<double>(file, "Name=\"pressure\"");
  const auto gap = array_of<double>(file, "Name=\"gap\"");
  const Grid& grid = solution.grid;

  BOOST_TEST(between(file, "NumberOfPoints=\"", "\"") == std::to_string(grid.size()));
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
  BOOST_TEST(file.find("\"shear\"") == std::string::npos);
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
    const std::string file = vtu(solution_on(grid, element));
    const auto corners = array_of<std::int64_t>(file, "Name=\"connectivity\"");
    const auto ends = array_of<std::int64_t>(file, "Name=\"offsets\"");
    const auto types = array_of<std::uint8_t>(file, "Name=\"types\"");
    BOOST_TEST(between(file, "NumberOfCells=\"", "\"") == std::to_string(ends.size()));
    BOOST_TEST_REQUIRE(types.size() == ends.size());
    BOOST_TEST_REQUIRE(corners.size() == n_corners * ends.size());
    double sum = 0;
    for (std::size_t cell = 0; cell < ends.size(); ++cell) {
      BOOST_TEST(ends[cell] == static_cast<std::int64_t>((cell + 1) * n_corners));
      BOOST_TEST(static_cast<int>(types[cell]) == (n_corners == 3 ? 5 : 9));
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
  const auto read = array_of<double>(vtu(solution, shear), "Name=\"shear\"");

  BOOST_TEST_REQUIRE(read.size() == 144U);
  BOOST_TEST(read[77] == shear[77]);
}

BOOST_AUTO_TEST_SUITE_END()
