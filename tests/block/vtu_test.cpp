// SPDX-License-Identifier: GPL-3.0-or-later
#include "block/exports.hpp"

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <boost/test/unit_test.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "block/paper_block.hpp"
#include "system/require.hpp"

BOOST_AUTO_TEST_SUITE(vtu_test)

namespace {

using boost::property_tree::ptree;

block::Solution solve() {
  const auto load = elasticity::linear_fall(1000, 0.6, 0.01);
  const block::Analysis analysis(paper_block::rectangle, paper_block::material, {load},
                                 {.order = 3, .refine = 0});
  return analysis.on(block::with_sides(block::Support::clamped)).fine().solve(load);
}

ptree read_piece(const block::Solution& solution, int n_cells) {
  std::stringstream file;
  block::write_vtu(file, solution, n_cells);
  ptree tree;
  boost::property_tree::read_xml(file, tree);  // throws unless well-formed
  return tree.get_child("VTKFile.UnstructuredGrid.Piece");
}

std::vector<double> numbers(const ptree& parent, const std::string& name) {
  for (const auto& [tag, array] : parent) {
    if (tag != "DataArray" || array.get("<xmlattr>.Name", std::string()) != name) continue;
    std::istringstream text(array.data());
    return {std::istream_iterator<double>(text), std::istream_iterator<double>()};
  }
  throw std::out_of_range(name);
}

}  // namespace

BOOST_AUTO_TEST_CASE(file_is_well_formed_and_its_arrays_have_the_stated_counts) {
  const block::Solution solution = solve();
  const auto n_elements = static_cast<std::size_t>(solution.model().mesh().n_elements());

  const ptree piece = read_piece(solution, 4);

  const auto n_points = std::stoul(piece.get<std::string>("<xmlattr>.NumberOfPoints"));
  const auto n_cells = std::stoul(piece.get<std::string>("<xmlattr>.NumberOfCells"));
  BOOST_TEST(n_points == 25 * n_elements);
  BOOST_TEST(n_cells == 16 * n_elements);
  BOOST_TEST(numbers(piece.get_child("Points"), "").size() == 3 * n_points);
  BOOST_TEST(numbers(piece.get_child("PointData"), "displacement").size() == 3 * n_points);
  BOOST_TEST(numbers(piece.get_child("PointData"), "stress").size() == 6 * n_points);
  BOOST_TEST(numbers(piece.get_child("PointData"), "von_mises").size() == n_points);
  BOOST_TEST(numbers(piece.get_child("Cells"), "connectivity").size() == 4 * n_cells);
  BOOST_TEST(numbers(piece.get_child("Cells"), "types").size() == n_cells);
  BOOST_TEST(numbers(piece.get_child("Cells"), "offsets").back() == 4.0 * double(n_cells));
}

BOOST_AUTO_TEST_CASE(cells_cover_the_block_counter_clockwise) {
  const ptree piece = read_piece(solve(), 0);
  const auto points = numbers(piece.get_child("Points"), "");
  const auto corners = numbers(piece.get_child("Cells"), "connectivity");

  double area = 0;
  for (std::size_t cell = 0; cell < corners.size(); cell += 4) {
    double twice = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      const auto here = 3 * static_cast<std::size_t>(corners[cell + k]);
      const auto next = 3 * static_cast<std::size_t>(corners[cell + (k + 1) % 4]);
      twice += points[here] * points[next + 1] - points[next] * points[here + 1];
    }
    BOOST_TEST(twice > 0);
    area += twice / 2;
  }
  BOOST_CHECK_CLOSE(area, 2.0, 1e-5);
}

BOOST_AUTO_TEST_CASE(points_carry_the_solution_with_y_up) {
  const block::Solution solution = solve();
  const ptree piece = read_piece(solution, 2);
  const auto points = numbers(piece.get_child("Points"), "");
  const auto displacement = numbers(piece.get_child("PointData"), "displacement");

  for (std::size_t k = 0; k < points.size(); k += 3 * 97) {
    const Eigen::Vector2d u = solution.displacement(points[k], -points[k + 1]);
    BOOST_TEST(std::abs(displacement[k] - u.x()) < 1e-13);
    BOOST_TEST(std::abs(displacement[k + 1] + u.y()) < 1e-13);
  }
}

BOOST_AUTO_TEST_CASE(too_many_cells_are_refused) {
  std::ostringstream file;

  BOOST_CHECK_THROW(block::write_vtu(file, solve(), 101), sys::InvalidQuantity);
}

BOOST_AUTO_TEST_SUITE_END()
