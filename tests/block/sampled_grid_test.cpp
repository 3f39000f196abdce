// SPDX-License-Identifier: GPL-3.0-or-later
#include "block/exports.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <string_view>
#include <vector>

#include "block/paper_block.hpp"
#include "system/require.hpp"

BOOST_AUTO_TEST_SUITE(sampled_grid_test)

namespace {

block::Solution solve() {
  const auto load = elasticity::linear_fall(1000, 0.6, 0.01);
  const block::Analysis analysis(paper_block::rectangle, paper_block::material, {load},
                                 {.order = 3, .refine = 0});
  return analysis.on(block::with_sides(block::Support::clamped)).fine().solve(load);
}

const std::vector<double>& field(const numerics::UnstructuredGrid& grid, std::string_view name) {
  return std::ranges::find(grid.fields, name, &numerics::UnstructuredGrid::Field::name)->values;
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_element_has_points_and_cells_of_its_own) {
  const block::Solution solution = solve();
  const auto n_elements = static_cast<std::size_t>(solution.model().mesh().n_elements());

  const numerics::UnstructuredGrid grid = block::sampled_grid(solution, 4);

  const std::size_t n_points = 25 * n_elements;
  BOOST_TEST(grid.points.size() == 3 * n_points);
  BOOST_TEST(grid.corners.size() == 4 * 16 * n_elements);
  BOOST_TEST(std::ranges::max(grid.corners) == static_cast<std::int64_t>(n_points) - 1);
  for (const numerics::UnstructuredGrid::Field& of : grid.fields) {
    BOOST_TEST(of.values.size() == static_cast<std::size_t>(of.n_components) * n_points, of.name);
  }
}

BOOST_AUTO_TEST_CASE(cells_cover_the_block_counter_clockwise) {
  const numerics::UnstructuredGrid grid = block::sampled_grid(solve());
  double area = 0;
  for (std::size_t cell = 0; cell < grid.corners.size(); cell += 4) {
    double twice = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      const auto here = 3 * static_cast<std::size_t>(grid.corners[cell + k]);
      const auto next = 3 * static_cast<std::size_t>(grid.corners[cell + (k + 1) % 4]);
      twice +=
          grid.points[here] * grid.points[next + 1] - grid.points[next] * grid.points[here + 1];
    }
    BOOST_TEST(twice > 0);
    area += twice / 2;
  }
  BOOST_CHECK_CLOSE(area, 2.0, 1e-10);
}

BOOST_AUTO_TEST_CASE(points_carry_the_solution_with_y_up) {
  const block::Solution solution = solve();
  const numerics::UnstructuredGrid grid = block::sampled_grid(solution, 2);
  const std::vector<double>& displacement = field(grid, "displacement");

  for (std::size_t point = 0; 3 * point < grid.points.size(); point += 97) {
    const double x = grid.points[3 * point];
    const double z = -grid.points[3 * point + 1];
    const Eigen::Vector2d u = solution.displacement(x, z);
    BOOST_TEST(std::abs(displacement[3 * point] - u.x()) < 1e-13);
    BOOST_TEST(std::abs(displacement[3 * point + 1] + u.y()) < 1e-13);
  }
}

BOOST_AUTO_TEST_CASE(points_carry_the_stresses_in_the_order_of_vtk) {
  const block::Solution solution = solve();
  const numerics::UnstructuredGrid grid = block::sampled_grid(solution, 2);
  const std::vector<double>& stress = field(grid, "stress");
  const std::vector<double>& mises = field(grid, "von_mises");
  const auto positions = Eigen::VectorXd::LinSpaced(3, -1, 1);

  std::size_t point = 0;
  for (block::Index e = 0; e < solution.model().mesh().n_elements(); ++e) {
    for (const block::PointState& state : solution.sample(e, positions)) {
      const double* xx = &stress[6 * point];  // then yy upwards, zz out of the plane, xy, yz, xz
      BOOST_TEST(xx[0] == state.stress.xx);
      BOOST_TEST(xx[1] == state.stress.zz);
      BOOST_TEST(xx[2] == state.stress.yy);
      BOOST_TEST(xx[3] == -state.stress.xz);
      BOOST_TEST((xx[4] == 0 && xx[5] == 0));
      BOOST_TEST(mises[point] == von_mises(state.stress));
      ++point;
    }
  }
  BOOST_TEST(point == mises.size());
}

BOOST_AUTO_TEST_CASE(too_many_cells_are_refused) {
  BOOST_CHECK_THROW(block::sampled_grid(solve(), 101), sys::InvalidQuantity);
}

BOOST_AUTO_TEST_SUITE_END()
