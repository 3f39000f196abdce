// SPDX-License-Identifier: GPL-3.0-or-later
#include "numerics/quadrature.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <string>

#include "numbers.hpp"

BOOST_AUTO_TEST_SUITE(quadrature_test)

using numerics::Estimate;
using numerics::Quadrature;
using numerics::QuadratureError;

namespace {

constexpr numerics::IntegralName some_integral{"some integral", 2.385};

void check_within_error(const Estimate& estimate, double exact) {
  const double rounding = tolerance::rounding * std::abs(exact);
  BOOST_TEST(std::abs(estimate.value - exact) <= estimate.abs_error + rounding);
}

}  // namespace

BOOST_AUTO_TEST_CASE(smooth_integrates_an_exponential_within_its_error) {
  Quadrature quadrature;
  const auto exponential = [](double s) { return std::exp(s); };

  const Estimate integral = quadrature.smooth(exponential, -1, 2, 1e-12, some_integral);

  check_within_error(integral, std::exp(2.0) - std::exp(-1.0));
  BOOST_TEST(integral.abs_error < 1e-12);
}

BOOST_AUTO_TEST_CASE(smooth_takes_21_evaluations_for_a_polynomial) {
  Quadrature quadrature;
  int n_evaluations = 0;
  const auto cubic = [&](double s) {
    ++n_evaluations;
    return s * s * s + 1;
  };

  check_within_error(quadrature.smooth(cubic, 0, 2, 1e-12, some_integral), 6);

  BOOST_TEST(n_evaluations == 21);
}

BOOST_AUTO_TEST_CASE(smooth_falls_back_on_bisection_at_a_singular_end) {
  Quadrature quadrature;
  const auto inverse_root = [](double s) { return 1 / std::sqrt(s); };

  check_within_error(quadrature.smooth(inverse_root, 0, 4, 1e-10, some_integral), 4);
}

BOOST_AUTO_TEST_CASE(adaptive_finds_a_narrow_peak) {
  Quadrature quadrature;
  const auto peak = [](double s) { return 1e-3 / (s * s + 1e-6); };

  check_within_error(quadrature.adaptive(peak, -1, 1, 1e-10, some_integral), 2 * std::atan(1e3));
}

BOOST_AUTO_TEST_CASE(the_principal_value_of_a_line_is_exact_and_takes_25_evaluations) {
  // PV∫₋₁² s/(s − 1/4) ds = 3 + ¼ ln(1.75/1.25)
  Quadrature quadrature;
  int n_evaluations = 0;
  const auto line = [&](double s) {
    ++n_evaluations;
    return s;
  };

  const Estimate integral = quadrature.principal_value(line, -1, 2, 0.25, 1e-12, some_integral);

  check_within_error(integral, 3 + 0.25 * std::log(1.75 / 1.25));
  BOOST_TEST(n_evaluations == 25);
}

BOOST_AUTO_TEST_CASE(a_divergent_integral_is_an_error_that_names_the_integral_and_the_point) {
  Quadrature quadrature(4);
  const auto wild = [](double s) { return std::sin(1 / s) / s; };

  BOOST_CHECK_EXCEPTION(quadrature.adaptive(wild, 1e-9, 1, 1e-12, some_integral), QuadratureError,
                        [](const QuadratureError& e) {
                          const std::string what = e.what();
                          return what.find("some integral") != what.npos &&
                                 what.find("x = 2.385") != what.npos;
                        });
}

BOOST_AUTO_TEST_CASE(an_integrand_that_is_not_finite_is_an_error) {
  Quadrature quadrature;
  const auto nan = [](double) { return std::numeric_limits<double>::quiet_NaN(); };

  BOOST_CHECK_THROW(quadrature.smooth(nan, 0, 1, 1e-12, some_integral), QuadratureError);
  BOOST_CHECK_THROW(quadrature.adaptive(nan, 0, 1, 1e-12, some_integral), QuadratureError);
  BOOST_CHECK_THROW(quadrature.principal_value(nan, 0, 1, 0.3, 1e-12, some_integral),
                    QuadratureError);
}

BOOST_AUTO_TEST_CASE(exceptions_of_the_integrand_pass_through) {
  struct FromInside {};
  Quadrature quadrature;
  const auto thrower = [](double) -> double { throw FromInside(); };

  BOOST_CHECK_THROW(quadrature.adaptive(thrower, 0, 1, 1e-12, some_integral), FromInside);
}

BOOST_AUTO_TEST_SUITE_END()
