// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/falling_pressure.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "elasticity/load_shapes.hpp"
#include "elasticity/surface_quadrature.hpp"

BOOST_AUTO_TEST_SUITE(falling_pressure_test)

using paper::FallingPressure;

namespace {

const elasticity::Material steel(206e3, 0.28);
constexpr double datum = 250;

double line(double t) {
  return 1 - t;
}
double parabola(double t) {
  return 1 - t * t;
}
double ellipse(double t) {
  return std::sqrt(1 - t * t);
}
double one(double) {
  return 1;
}

}  // namespace

BOOST_AUTO_TEST_CASE(resultant_and_second_moment_are_those_of_the_shape) {
  const auto close = boost::test_tools::tolerance(2e-4);
  const FallingPressure of_line(line, 63.5, 38.1, 0.42);
  BOOST_TEST(of_line.line_load() == 0.42 * (63.5 + 38.1), boost::test_tools::tolerance(1e-14));
  // ∫x²p/∫p of a triangle a²/6, of a parabola a²/5, of an ellipse a²/4, of a uniform pressure a²/3
  const std::pair<double (*)(double), double> shares[] = {
      {line, 1. / 6}, {parabola, 1. / 5}, {ellipse, 1. / 4}, {one, 1. / 3}};
  for (const auto& [shape, share] : shares) {
    BOOST_TEST(FallingPressure(shape, 63.5, 0, 0.42).second_moment() == share * 0.42 * 0.42, close);
  }
}

BOOST_AUTO_TEST_CASE(a_triangle_is_equation_3) {
  const FallingPressure triangle(line, 63.5, 0, 0.42);
  for (const double x : {0.0, 0.2, 0.42, 1.7}) {
    const double expected =
        normal_displacement(steel, elasticity::TriangularLoad(63.5, 0.42), x, datum);
    BOOST_TEST(triangle.displacement(steel, x, datum) == expected,
               boost::test_tools::tolerance(1e-13));
  }
}

BOOST_AUTO_TEST_CASE(displacements_of_curved_shapes_agree_with_quadrature) {
  for (const auto shape : {parabola, ellipse}) {
    const FallingPressure pressure(shape, 63.5, 12.7, 0.42);
    const elasticity::SurfaceQuadrature surface(steel, pressure.load(), datum);
    for (const double x : {0.0, 0.31, 0.6, 2.385}) {
      BOOST_TEST(pressure.displacement(steel, x, datum) == surface.normal_displacement(x).value,
                 boost::test_tools::tolerance(2e-4));
    }
  }
}

BOOST_AUTO_TEST_CASE(the_work_under_a_constant_displacement_is_half_of_load_times_displacement) {
  const FallingPressure pressure(parabola, 63.5, 12.7, 0.42);
  BOOST_TEST(pressure.work([](double) { return 0.003; }) == 0.0015 * pressure.line_load(),
             boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(the_largest_shear_matches_the_textbook) {
  // σ_xz of a uniform pressure is largest on the vertical beneath its end, at the surface: p/π
  // (Johnson 2.30b). For the linear fall from 1000 to 600 over 0.01 it is 237.98 (independent p-FEM
  // code), for a parabola of 974 over 0.0123 225.4.
  BOOST_TEST(FallingPressure(one, 63.5, 0, 0.42).largest_shear() == 63.5 / std::numbers::pi,
             boost::test_tools::tolerance(0.005));
  BOOST_TEST(FallingPressure(line, 1000, 600, 0.01).largest_shear() == 237.98,
             boost::test_tools::tolerance(1e-4));
  BOOST_TEST(FallingPressure(parabola, 974.05, 0, 0.01231).largest_shear() == 225.4,
             boost::test_tools::tolerance(2e-4));
}

BOOST_AUTO_TEST_SUITE_END()
