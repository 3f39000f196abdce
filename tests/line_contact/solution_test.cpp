// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_contact/solution.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "elasticity/loads.hpp"
#include "elasticity/surface_quadrature.hpp"
#include "line_contact/cases.hpp"
#include "line_contact/methods.hpp"
#include "numbers.hpp"

BOOST_AUTO_TEST_SUITE(solution_test)

using namespace line_cases;
using Eigen::Index;
using Eigen::VectorXd;
using elasticity::Stress;
using line_contact::Region;
using line_contact::Solution;
using line_contact::solve_by_matrix_inversion;
using tolerance::relative_difference;

namespace {

// A solution made of given pressures.
Solution with_pressure(Element element, const VectorXd& pressure, double centre = 0) {
  return {{Profile::parabola(1), modulus, {pressure.size(), 0.25, centre}, element},
          pressure,
          VectorXd::Zero(pressure.size())};
}

double distance(const Stress& s, const Stress& t) {
  return std::max({std::abs(s.xx - t.xx), std::abs(s.zz - t.zz), std::abs(s.xz - t.xz)});
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_half_width_is_twice_the_root_of_the_second_moment) {
  // One element alone: its own moment, c²/6 of a triangle, c²/12 of a strip.
  VectorXd pressure = VectorXd::Zero(11);
  pressure[3] = 2.385;
  const double c = 0.25;
  BOOST_TEST(with_pressure(Element::point, pressure).half_width() < 1e-8);
  BOOST_TEST(relative_difference(with_pressure(Element::uniform, pressure).half_width(),
                                 2 * c / std::sqrt(12.0)) < 1e-14);
  BOOST_TEST(relative_difference(with_pressure(Element::triangular, pressure, 1.7).half_width(),
                                 2 * c / std::sqrt(6.0)) < 1e-13);
  // Two forces 4c apart: moment (2c)²
  pressure[7] = 2.385;
  BOOST_TEST(relative_difference(with_pressure(Element::point, pressure).half_width(), 4 * c) <
             1e-14);
}

BOOST_AUTO_TEST_CASE(regions_end_where_the_square_of_the_pressure_extrapolates_to_zero) {
  VectorXd p = VectorXd::Zero(12);
  // p² = 1, 2, 3 falls by 1 per node and so ends one node beyond the first; a single node ends half
  // a node beyond
  p.segment(2, 4) << 1, std::sqrt(2), std::sqrt(3), std::sqrt(1.5);
  p[9] = 0.5;
  const auto regions = with_pressure(Element::triangular, p).regions();
  const auto x = [](double i) { return (i - 5.5) * 0.25; };

  BOOST_REQUIRE(regions.size() == 2U);
  BOOST_TEST(std::abs(regions[0].begin - x(1)) < 1e-14);
  BOOST_TEST(std::abs(regions[0].end - x(6)) < 1e-14);
  BOOST_TEST(regions[0].n_nodes == 4);
  BOOST_TEST(relative_difference(regions[0].load, 0.25 * p.segment(2, 4).sum()) < 1e-15);
  BOOST_TEST(regions[1].begin == x(8.5));
  BOOST_TEST(regions[1].end == x(9.5));
}

BOOST_AUTO_TEST_CASE(regions_of_a_wavy_profile_are_found_on_any_grid) {
  const auto fine = line_contact::solve_by_fft(problem_of(cases[1], 1 << 13), load);
  const auto coarse = solve_by_matrix_inversion(problem_of(cases[1], 512), load);
  const auto found = fine.regions(), expected = coarse.regions();

  BOOST_REQUIRE(found.size() == expected.size());
  BOOST_TEST(found.size() >= 3U);
  double sum = 0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    BOOST_TEST(std::abs(found[i].begin - expected[i].begin) < coarse.grid.spacing);
    BOOST_TEST(std::abs(found[i].end - expected[i].end) < coarse.grid.spacing);
    BOOST_TEST(std::abs(found[i].load - expected[i].load) < 0.01 * load);
    sum += found[i].load;
  }
  BOOST_TEST(relative_difference(sum, load) < 1e-13);
}

BOOST_AUTO_TEST_CASE(the_approach_at_a_datum_is_that_of_hertz) {
  for (const Element element : elements) {
    const Solution s = solve_by_matrix_inversion(cylinders_on(301, element), load);
    for (const double datum : {1.3, -2.385, 1e4}) {
      const double exact = hertz.approach(datum * hertz.half_width());
      BOOST_TEST(relative_difference(s.approach(datum * hertz.half_width()), exact) < 1e-4);
    }
  }
  // Bodies that are farther apart at first approach by as much more.
  Problem wavy = problem_of(cases[1], 300);
  const double before = solve_by_fft(wavy, load).approach(3);
  wavy.profile = wavy_profile(0.02385);
  BOOST_TEST(std::abs(solve_by_fft(wavy, load).approach(3) - before - 0.02385) < 1e-9);
}

BOOST_AUTO_TEST_CASE(the_slope_between_nodes_satisfies_equation_2) {
  const Solution s = solve_by_matrix_inversion(cylinders_on(61), load);
  // The pressure as a load, linear between nodes; both bodies as one with E* for E and ν = 0.
  std::vector<numerics::Piece> pieces;
  for (Index i = 0; i + 1 < s.grid.n_nodes; ++i) {
    if (s.pressure[i] == 0 && s.pressure[i + 1] == 0) continue;
    const double x1 = s.grid.x(i), x2 = s.grid.x(i + 1), p1 = s.pressure[i], p2 = s.pressure[i + 1];
    pieces.push_back({x1, x2, [=](double x) { return std::lerp(p1, p2, (x - x1) / (x2 - x1)); }});
  }
  const elasticity::SurfaceQuadrature quadrature(elasticity::Material(modulus, 0),
                                                 {numerics::PiecewiseFunction(pieces)}, 10);
  for (const double share : {-1.4, -0.385, 0.0, 0.7, 1.0}) {
    const double x = share * hertz.half_width();
    BOOST_TEST(std::abs(surface_slope(s, x) - quadrature.normal_gradient(x).value) <
               1e-10 * curvature * hertz.half_width());
  }
}

BOOST_AUTO_TEST_CASE(beneath_the_contact_stresses_approach_mcewens_with_order_3_2) {
  // The square root at the edges, between evenly spaced nodes, costs half an order.
  const line_contact::McEwen mcewen(hertz);
  const double a = hertz.half_width();
  const auto error = [&](Index n_nodes) {
    const Solution s = solve_by_matrix_inversion(cylinders_on(n_nodes), load);
    double greatest = 0;
    for (const double x : {-1.1, 0.0, 0.5}) {
      for (const double z : {0.385, 0.786, 3.1}) {
        greatest = std::max(greatest,
                            distance(stress_beneath(s, x * a, z * a), mcewen.stress(x * a, z * a)));
      }
    }
    return greatest / hertz.peak_pressure();
  };
  BOOST_TEST(error(81) < 2e-3);
  BOOST_TEST(error(641) < 6e-5);
  BOOST_TEST(error(641) < error(81) / 16);
}

BOOST_AUTO_TEST_CASE(a_warning_states_the_error_of_a_coarse_contact) {
  const double a = hertz.half_width();
  for (const Element element : {Element::triangular, Element::uniform}) {
    for (double across = 9; across < 30; across += 0.37) {
      const Problem problem{Profile::parabola(curvature), modulus, {60, 2 * a / across}, element};
      const Solution s = solve_by_matrix_inversion(problem, load);
      const std::string warning = contact::resolution_warning(s.resolution());
      const double error = std::max(std::abs(s.half_width() / a - 1),
                                    std::abs(s.peak_pressure() / hertz.peak_pressure() - 1));
      BOOST_TEST_CONTEXT(name_of(element) << ", " << across << ": " << error << ", " << warning) {
        BOOST_TEST(warning.empty() == (s.n_in_contact() >= 20));
        if (warning.empty()) continue;
        const double percent = std::stod(warning.substr(warning.find("about ") + 6));
        BOOST_TEST(error < 1.6 * percent / 100);
      }
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
