// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/load_fit.hpp"

#include <fmt/core.h>
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "elasticity/loads.hpp"
#include "elasticity/surface_quadrature.hpp"
#include "parameters/papers_case.hpp"

BOOST_AUTO_TEST_SUITE(load_fit_test)

using paper::FallingPressure;
using paper::FittedLoad;
using paper::LoadFitting;
using paper::Width;

namespace {

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

// The paper's points, with the displacements of a half-space under a load as if they were printed;
// a level would be the same for all loads.
struct Made {
  parameters::Case c = case_of(papers_text());
  paper::PrintedData printed = paper::read_printed(c).value();
  paper::Level level{
      "none", {0, 0, std::vector<double>(11, 0.)}, {0, 0, std::vector<double>(11, 0.)}};

  explicit Made(const FallingPressure& load) {
    const paper::HalfSpaceCase& h = c.half_space;
    for (std::size_t i = 0; i < h.points.size(); ++i) {
      printed.figure5.fea_z[i] = parameters::PrintedNumber(
          fmt::format("{:.15e}", load.displacement(h.material, h.points[i], h.datum)));
    }
  }

  LoadFitting fitting() const { return {c.half_space, printed, level}; }
};

const elasticity::Material steel(206e3, 0.28);
constexpr double datum = 250;

}  // namespace

BOOST_AUTO_TEST_CASE(the_largest_shear_is_that_of_closed_forms) {
  // Johnson (1985): p/π beneath the ends of a strip, sec. 2.5; 0.25 p₀ beneath a semi-ellipse, at
  // x = 0.87 a and z = 0.5 a, sec. 4.2.
  const auto strip = [](double) { return 1.0; };
  const auto ellipse = [](double t) { return std::sqrt(std::max(0.0, 1 - t * t)); };

  BOOST_TEST(FallingPressure(strip, 800, 800, 0.01).largest_shear() == 800 / std::numbers::pi,
             boost::test_tools::tolerance(1e-12));
  BOOST_TEST(FallingPressure(ellipse, 1000, 0, 0.01).largest_shear() == 250,
             boost::test_tools::tolerance(2e-3));
}

BOOST_AUTO_TEST_CASE(a_linear_fall_returns_its_pressures_and_its_half_width) {
  const LoadFitting fitting = Made(FallingPressure(line, 1017, 583, 0.0093)).fitting();

  const FittedLoad fitted = fitting.fit({"line", line}, false, 0.010, Width::fitted);

  const auto close = boost::test_tools::tolerance(1e-7);
  BOOST_TEST(fitted.peak.value == 1017, close);
  BOOST_TEST(fitted.numbers[0] == 583, close);
  BOOST_TEST(fitted.half_width.value == 0.0093, close);
  BOOST_TEST(fitted.meets_all());
  BOOST_TEST(fitted.largest_residual() < 1e-9);
}

BOOST_AUTO_TEST_CASE(a_parabola_alone_returns_its_peak_and_width) {
  const LoadFitting fitting = Made(FallingPressure(parabola, 974, 0, 0.0123)).fitting();

  const FittedLoad fitted = fitting.fit({"parabola", parabola}, true, 0.010, Width::fitted);

  BOOST_TEST(fitted.peak.value == 974, boost::test_tools::tolerance(1e-7));
  BOOST_TEST(fitted.half_width.value == 0.0123, boost::test_tools::tolerance(1e-7));
}

BOOST_AUTO_TEST_CASE(a_wrong_shape_misses_but_its_resultant_is_nearly_right) {
  const LoadFitting fitting = Made(FallingPressure(line, 1000, 600, 0.010)).fitting();

  const FittedLoad fitted = fitting.fit({"line", line}, true, 0.010, Width::held);

  BOOST_TEST(!fitted.meets_all());
  BOOST_TEST(fitted.pressure.line_load() == 16, boost::test_tools::tolerance(1e-2));
}

BOOST_AUTO_TEST_CASE(uncertainties_are_those_of_the_normal_equations) {
  // One number: u² = 1/Σ(r/s)², r the displacement under unit pressure over the observed one.
  const FallingPressure load(one, 820, 0, 0.010);
  const LoadFitting fitting = Made(load).fitting();

  const FittedLoad fitted = fitting.fit({"uniform", one}, true, 0.010, Width::held);

  double sum = 0;
  for (const double s : fitting.convergences()) sum += 1 / (820. * 820. * s * s);
  BOOST_TEST(fitted.peak.standard == 1 / std::sqrt(sum), boost::test_tools::tolerance(1e-9));
}

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
