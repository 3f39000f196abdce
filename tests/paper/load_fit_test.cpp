// SPDX-License-Identifier: GPL-3.0-or-later
// Fits to displacements under a known load.
#include "paper/load_fit.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "parameters/papers_case.hpp"

BOOST_AUTO_TEST_SUITE(load_fit_test)

using paper::FallingPressure;
using paper::FittedLoad;
using paper::LoadFitting;
using paper::Shape;
using paper::Width;

namespace {

const Shape line{"line", [](double t) { return 1 - t; }};
const Shape parabola{"parabola", [](double t) { return 1 - t * t; }};
const Shape uniform{"uniform", [](double) { return 1; }};

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
  const LoadFitting fitting = Made(FallingPressure(line.f, 1017, 583, 0.0093)).fitting();

  const FittedLoad fitted = fitting.fit(line, false, 0.010, Width::fitted);

  const auto close = boost::test_tools::tolerance(1e-7);
  BOOST_TEST(fitted.peak.value == 1017, close);
  BOOST_TEST(fitted.numbers[0] == 583, close);
  BOOST_TEST(fitted.half_width.value == 0.0093, close);
  BOOST_TEST(fitted.meets_all());
  BOOST_TEST(fitted.largest_residual() < 1e-9);
}

BOOST_AUTO_TEST_CASE(a_parabola_alone_returns_its_peak_and_width) {
  const LoadFitting fitting = Made(FallingPressure(parabola.f, 974, 0, 0.0123)).fitting();

  const FittedLoad fitted = fitting.fit(parabola, true, 0.010, Width::fitted);

  BOOST_TEST(fitted.peak.value == 974, boost::test_tools::tolerance(1e-7));
  BOOST_TEST(fitted.half_width.value == 0.0123, boost::test_tools::tolerance(1e-7));
}

BOOST_AUTO_TEST_CASE(a_wrong_shape_misses_but_its_resultant_is_nearly_right) {
  const LoadFitting fitting = Made(FallingPressure(line.f, 1000, 600, 0.010)).fitting();

  const FittedLoad fitted = fitting.fit(line, true, 0.010, Width::held);

  BOOST_TEST(!fitted.meets_all());
  BOOST_TEST(fitted.pressure.line_load() == 16, boost::test_tools::tolerance(1e-2));
}

BOOST_AUTO_TEST_CASE(uncertainties_are_those_of_the_normal_equations) {
  // One number: u² = 1/Σ(r/s)², r the displacement under unit pressure over the observed one.
  const FallingPressure load(uniform.f, 820, 0, 0.010);
  const LoadFitting fitting = Made(load).fitting();

  const FittedLoad fitted = fitting.fit(uniform, true, 0.010, Width::held);

  double sum = 0;
  for (const double s : fitting.convergences()) sum += 1 / (820. * 820. * s * s);
  BOOST_TEST(fitted.peak.standard == 1 / std::sqrt(sum), boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_SUITE_END()
