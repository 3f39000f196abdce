// SPDX-License-Identifier: GPL-3.0-or-later
// The block under the paper's triangle against eq. (3), far from the clamps.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "block/paper_block.hpp"
#include "elasticity/triangular_load.hpp"

BOOST_AUTO_TEST_SUITE(half_space_test)

namespace {

const elasticity::TriangularLoad triangle(1000, paper_block::half_width);

double half_space_drop(double x) {
  return elasticity::normal_displacement(paper_block::material, triangle, 0, 10) -
         elasticity::normal_displacement(paper_block::material, triangle, x, 10);
}

// Largest error of u_z(0) − u_z(x) over five load widths, against that of the half-space.
double error_of_block(double size) {
  const elasticity::Load load = triangle;
  const block::Analysis analysis({2 * size, size}, paper_block::material, {load},
                                 {.order = 8, .refine = 1});
  const block::Solution solution =
      analysis.on(block::with_sides(block::Support::clamped)).fine().solve(load);
  double error = 0;
  for (const double x : {0.005, 0.01, 0.02, 0.035, 0.05}) {
    const double drop = solution.displacement(0, 0).y() - solution.displacement(x, 0).y();
    error = std::max(error, std::abs(drop - half_space_drop(x)) / half_space_drop(x));
  }
  return error;
}

}  // namespace

BOOST_AUTO_TEST_CASE(block_becomes_a_half_space_with_the_square_of_its_size) {
  // The clamps bend the surface under the load by a curvature like 1/size²
  const double at_1 = error_of_block(1);
  const double at_2 = error_of_block(2);
  const double at_4 = error_of_block(4);

  BOOST_TEST(at_1 / at_2 == 4, boost::test_tools::tolerance(0.05));
  BOOST_TEST(at_2 / at_4 == 4, boost::test_tools::tolerance(0.05));
  BOOST_TEST(error_of_block(64) < 2e-6);
}

BOOST_AUTO_TEST_SUITE_END()
