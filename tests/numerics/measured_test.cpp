// SPDX-License-Identifier: GPL-3.0-or-later
#include "numerics/measured.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "message_of.hpp"
#include "random_inputs.hpp"
#include "system/require.hpp"

BOOST_AUTO_TEST_SUITE(measured_test)

using numerics::Estimate;
using numerics::Measured;
using sys::InvalidQuantity;

namespace {

void check(const Measured& number, double value, double standard) {
  BOOST_TEST(number.value() == value, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(number.standard() == standard, boost::test_tools::tolerance(1e-12));
}

}  // namespace

// The figures are those of the Python package uncertainties 3.1.6, printed with 17 digits; the
// first four expressions are from its manual.
BOOST_AUTO_TEST_CASE(propagates_as_the_package_uncertainties_does) {
  const Measured x(0.20, 0.01, "x");
  check(pow(x, 2), 0.04, 0.004);
  check(sin(1 + pow(x, 2)), 0.8624042272433384, 0.0020248810289311137);
  check(2 * x + 1000, 1000.4, 0.02);
  const Measured u(1, 0.05, "u"), v(10, 0.1, "v");
  check(u + 2 * v, 21, 0.20615528128088306);
  check(u + 2 * v - u, 20, 0.2);

  const Measured a(2.5, 0.03, "a"), b(-1.2, 0.02, "b");
  check(a / b, -2.0833333333333335, 0.042785893890970456);
  check(a / (a + b), 1.923076923076923, 0.03645661964674405);
  check(exp(b) * log(a), 0.27598146486929104, 0.006597703604606325);
  check(sqrt(a * a + b * b), 2.773084924772409, 0.02839668839096334);
  check(atan(a / b), -1.1232763516377269, 0.008011922913263648);
  check(pow(cos(a * b), 3), -0.9702769379215033, 0.025564467748467934);
  BOOST_TEST(covariance(a * b, a / b) == -0.0008361111111111113,
             boost::test_tools::tolerance(1e-12));
  BOOST_TEST(correlation(a * b, a / b) == -0.3171759747102213, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(what_has_its_source_in_common_cancels) {
  const Measured x(0.2, 0.01, "x");
  BOOST_TEST((x - x).standard() == 0);
  BOOST_TEST((x - x).components().empty());
  BOOST_TEST((pow(x, 2) - x * x).standard() == 0);
  BOOST_TEST((x / x).standard() == 0);
  // What cancels in several steps leaves no rounding either.
  const Measured s(0.5129570197365967, 0.001072250924942302, "s");
  BOOST_TEST((s / (Measured(3) * s)).components().empty());
  const Measured twice = 0.7 * s, thrice = 0.71 * s;
  BOOST_TEST(((twice - thrice) / thrice).components().empty());
  BOOST_TEST((x - Measured(0.2, 0.01, "another")).standard() == 0.01 * std::numbers::sqrt2,
             boost::test_tools::tolerance(1e-14));
}

// 1.83 and 1.80 are no doubles: what their difference is known to is not more than they were.
BOOST_AUTO_TEST_CASE(what_is_left_where_an_uncertainty_cancels_is_as_wrong_as_its_rounding) {
  const Measured left = Measured(1.83, 0.03, "gauge") - Measured(1.80, 0.03, "gauge");
  BOOST_TEST(left.standard() == 0);
  BOOST_TEST(std::abs(left.value() - 0.03) > 0);
  BOOST_TEST(left.bounded().abs_error >= std::abs(left.value() - 0.03));
  BOOST_TEST(left.bounded().abs_error < 1e-15);
  const Measured x(1.83, 0.03, "gauge");
  BOOST_TEST((x - x).bounded().abs_error == 0);
}

BOOST_AUTO_TEST_CASE(weights_from_one_balance_are_correlated_by_it) {
  const auto weighed = [](double value, const char* run) {
    return Measured(value, 0.03, run) + Measured(0, 0.04, "calibration/balance");
  };
  const Measured first = weighed(5, "statistics/first"), second = weighed(7, "statistics/second");
  BOOST_TEST(correlation(first, second) == 0.64, boost::test_tools::tolerance(1e-14));
  const Measured sum = first + second;
  BOOST_TEST(sum.kinds().at("statistics") == 0.03 * std::numbers::sqrt2,
             boost::test_tools::tolerance(1e-14));
  BOOST_TEST(sum.kinds().at("calibration") == 0.08, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(!(second - first).kinds().contains("calibration"));
}

BOOST_AUTO_TEST_CASE(a_bound_and_a_standard_uncertainty_stay_apart) {
  const Measured length = Measured(2, 0.1, "ruler") + Measured::bounded({1, 0.25});
  BOOST_TEST(length.standard() == 0.1);
  BOOST_TEST(length.bounded().abs_error == 0.25);
  const Measured area = 4 * length;
  BOOST_TEST(area.standard() == 0.4);
  BOOST_TEST(area.bounded().abs_error == 1);
  BOOST_TEST((length - length).bounded().abs_error == 0.5);
}

// Drawn from normal distributions, as JCGM 101:2008 (Supplement 1 of the GUM) does. The mean is
// moved by the terms of second order, and the standard deviation by their square over it.
BOOST_AUTO_TEST_CASE(draws_are_within_what_linear_theory_says_that_it_neglects) {
  struct Example {
    const char* name;
    std::function<Measured(Measured, Measured)> measured;
    std::function<double(double, double)> drawn;
  };
  const std::vector<Example> examples{
      {"ratio", [](auto a, auto b) { return a / b; }, [](double a, double b) { return a / b; }},
      {"square", [](auto a, auto) { return pow(a, 2); }, [](double a, double) { return a * a; }},
      {"exponential", [](auto a, auto b) { return exp(a) * b; },
       [](double a, double b) { return std::exp(a) * b; }},
      {"logarithm", [](auto a, auto b) { return log(a) - cos(b); },
       [](double a, double b) { return std::log(a) - std::cos(b); }},
      {"root", [](auto a, auto b) { return sqrt(a * a + b * b); },
       [](double a, double b) { return std::hypot(a, b); }}};
  constexpr int n_draws = 400'000;
  constexpr double a = 1.2, u_a = 0.06, b = 2.1, u_b = 0.12;
  RandomInputs random(101);
  for (const Example& example : examples) {
    double sum = 0, squares = 0;
    const Measured linear = example.measured({a, u_a, "a"}, {b, u_b, "b"});
    for (int n = 0; n < n_draws; ++n) {
      const double drawn_a = a + u_a * random.normal();
      const double off = example.drawn(drawn_a, b + u_b * random.normal()) - linear.value();
      sum += off;
      squares += off * off;
    }
    const double mean = sum / n_draws;
    const double deviation = std::sqrt(squares / n_draws - mean * mean);
    const double scatter = 5 * deviation / std::sqrt(n_draws);
    BOOST_TEST_CONTEXT(example.name) {
      const double u = linear.standard(), q = linear.neglected();
      BOOST_TEST(q < 0.2 * u);
      BOOST_TEST(std::abs(mean) <= q + scatter);
      BOOST_TEST(std::abs(deviation - u) <= 4 * q * q / u + scatter);
    }
  }
}

BOOST_AUTO_TEST_CASE(tells_where_linear_theory_does_not_hold) {
  const Measured square = pow(Measured(0, 1, "x"), 2);  // χ² of one degree: mean 1, not 0
  BOOST_TEST(square.standard() == 0);
  BOOST_TEST(square.neglected() == 1);
  const Measured product = Measured(0.1, 1, "a") * Measured(0.1, 1, "b");
  BOOST_TEST(product.neglected() > product.standard());
  BOOST_TEST((square + 3).neglected() == 1);
  const Measured a(2, 0.2, "a");
  BOOST_TEST((a / a).neglected() == 0);
  BOOST_TEST((1 / a).neglected() == 0.5 * 0.01, boost::test_tools::tolerance(1e-14));
  const Measured clock(1, 0.1, "clock");
  const Measured ratio = (Measured(8, 0.008, "h") * clock) / (Measured(2, 0.002, "p") * clock);
  BOOST_TEST(ratio.standard() == 4e-3 * std::sqrt(2.0), boost::test_tools::tolerance(1e-12));
  BOOST_TEST(ratio.neglected() < 0.25 * ratio.standard() + 1e-9);
  BOOST_TEST(Measured(3, 0.1, "x").neglected() == 0);
}

BOOST_AUTO_TEST_CASE(refuses_what_has_no_meaning) {
  const Measured near_zero(0.1, 0.08, "x");
  const Measured with_bound = near_zero + Measured::bounded({0, 0.03});
  BOOST_CHECK_NO_THROW(1 / near_zero);
  BOOST_CHECK_THROW(1 / with_bound, InvalidQuantity);
  BOOST_CHECK_THROW(log(with_bound), InvalidQuantity);
  BOOST_TEST(message_of<InvalidQuantity>([] { log(Measured(0.1, 0.2, "scale/1990")); }) ==
             "argument of log = 0.1: must be farther from 0 than its bound and its standard "
             "uncertainty of 'scale/1990', 0.2");
  BOOST_CHECK_THROW(sqrt(with_bound), InvalidQuantity);
  BOOST_CHECK_THROW(pow(with_bound, 0.5), InvalidQuantity);
  BOOST_CHECK_NO_THROW(pow(with_bound, 2));
  BOOST_CHECK_THROW(Measured(1, -0.1, "x"), InvalidQuantity);
  BOOST_CHECK_THROW(Measured(1, NAN, "x"), InvalidQuantity);
  BOOST_CHECK_THROW(Measured(NAN, 0.1, "x"), InvalidQuantity);
  BOOST_CHECK_THROW(Measured(1, 0.1, ""), InvalidQuantity);
  BOOST_CHECK_THROW(Measured{INFINITY}, InvalidQuantity);
  BOOST_CHECK_THROW(Measured::bounded({1, -1}), InvalidQuantity);
  BOOST_CHECK_THROW(correlation(near_zero, 2), InvalidQuantity);
  BOOST_CHECK_THROW(exp(Measured(700, 1e300, "x")), InvalidQuantity);
}

BOOST_AUTO_TEST_SUITE_END()
