// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/solution.hpp"

#include <Eigen/Geometry>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "numbers.hpp"
#include "point_contact/cases.hpp"
#include "point_contact/methods.hpp"

BOOST_AUTO_TEST_SUITE(solution_test)

using namespace point_cases;
using Eigen::Index;
using Eigen::VectorXd;
using point_contact::Solution;
using point_contact::Vector2;
using tolerance::relative_difference;

namespace {

// Pressures on 40 × 30 nodes from a function of the position in spacings from the middle.
template <class Pressure>
Solution with_pressure(Element element, const Pressure& pressure) {
  const Grid grid{0.25, 40, 30};
  VectorXd p(grid.size());
  for (Index j = 0; j < grid.n2; ++j) {
    for (Index i = 0; i < grid.n1; ++i) {
      p[grid.index(i, j)] = pressure(Vector2(grid.node(i, j) / grid.spacing));
    }
  }
  return {{Profile::paraboloid(1), modulus, grid, element}, p, VectorXd::Zero(p.size())};
}

}  // namespace

BOOST_AUTO_TEST_CASE(semi_axes_are_the_principal_second_moments_of_the_pressure) {
  // One element: (1, 1)/12 of a square; with (−1, 1) smeared as well 1/12 and 3/12 along diagonals.
  const auto one = [](const Vector2& at) {
    return (at - Vector2(2.5, -3.5)).norm() < 0.1 ? 3. : 0;
  };
  const Vector2 uniform = with_pressure(Element::uniform, one).semi_axes();
  const Vector2 pyramid = with_pressure(Element::pyramid, one).semi_axes();
  BOOST_TEST(relative_difference(uniform[0], 0.25 * std::sqrt(5. / 12)) < 1e-12);
  BOOST_TEST(relative_difference(uniform[1], 0.25 * std::sqrt(5. / 12)) < 1e-12);
  BOOST_TEST(relative_difference(pyramid[0], 0.25 * std::sqrt(15. / 12)) < 1e-12);
  BOOST_TEST(relative_difference(pyramid[1], 0.25 * std::sqrt(5. / 12)) < 1e-12);
}

BOOST_AUTO_TEST_CASE(an_ellipse_turned_by_any_angle_keeps_its_semi_axes) {
  for (const double angle : {0.0, 0.5, 1.2, 2.9}) {
    const Eigen::Rotation2Dd turn(-angle);
    const Solution s = with_pressure(Element::uniform, [&](const Vector2& at) {
      const Vector2 q = turn * at;
      const double square = 1 - std::pow(q.x() / 12, 2) - std::pow(q.y() / 7, 2);
      return square > 0 ? std::sqrt(square) : 0;
    });
    BOOST_TEST(relative_difference(s.semi_axes()[0], 0.25 * 12) < 0.01);
    BOOST_TEST(relative_difference(s.semi_axes()[1], 0.25 * 7) < 0.01);
    BOOST_TEST(relative_difference(s.area_semi_axes()[0], 0.25 * 12) < 0.02);
    BOOST_TEST(relative_difference(s.area_semi_axes()[1], 0.25 * 7) < 0.02);
    BOOST_TEST(relative_difference(s.contact_area(), 0.0625 * std::numbers::pi * 84) < 0.02);
  }
}

BOOST_AUTO_TEST_CASE(regions_are_connected_nodes_in_order_of_falling_load) {
  // Two disks that touch at a corner along (1, 1), which is not an edge of a pyramid, and a heavy
  // node.
  const Solution s = with_pressure(Element::pyramid, [](const Vector2& at) {
    if ((at - Vector2(15.5, 10.5)).norm() < 0.1) return 100.0;
    if (at.x() < 0 && at.y() < 0 && at.x() > -5 && at.y() > -5) return 1.0;
    return at.x() > 0 && at.y() > 0 && at.x() < 3 && at.y() < 3 ? 2.0 : 0.0;
  });
  const auto found = point_contact::regions(s);
  BOOST_REQUIRE(found.size() == 3U);
  BOOST_TEST(found[0].load == 100 * 0.0625);
  BOOST_TEST((found[0].centre - 0.25 * Vector2(15.5, 10.5)).norm() < 1e-14);
  BOOST_TEST(found[1].n_nodes == 25);
  BOOST_TEST(found[1].area == 25 * 0.0625);
  BOOST_TEST(found[2].n_nodes == 9);
  BOOST_TEST(found[0].load + found[1].load + found[2].load == s.load());
}

BOOST_AUTO_TEST_CASE(a_measured_surface_touches_in_regions_that_carry_the_load) {
  const Solution s = solve_for_load(problem_of(cases[2], 200), load);
  const auto found = point_contact::regions(s);
  double sum = 0;
  for (const auto& region : found) sum += region.load;
  BOOST_TEST(found.size() >= 3U);
  BOOST_TEST(relative_difference(sum, load) < 1e-13);
}

BOOST_AUTO_TEST_CASE(a_warning_states_the_error_of_a_coarse_contact) {
  for (const Element element : elements) {
    for (double across = 5; across < 28; across += 0.71) {
      const Problem problem{
          Profile::paraboloid(curvature), modulus, {2 * hertz.radius() / across, 48, 47}, element};
      const Solution s = solve_for_load(problem, load);
      const std::string warning = contact::resolution_warning(s.resolution());
      const double error = std::max(std::abs(s.semi_axes().mean() / hertz.radius() - 1),
                                    std::abs(s.peak_pressure() / hertz.peak_pressure() - 1));
      BOOST_TEST_CONTEXT(name_of(element) << ", " << across << ": " << error << ", " << warning) {
        BOOST_TEST(warning.empty() == (s.resolution().n_across >= 20));
        if (warning.empty()) continue;
        const double percent = std::stod(warning.substr(warning.find("about ") + 6));
        BOOST_TEST(error < 1.6 * percent / 100);
      }
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
