// SPDX-License-Identifier: GPL-3.0-or-later
#include "numerics/scatter.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <vector>

#include "system/require.hpp"
#include "tolerances.hpp"

BOOST_AUTO_TEST_SUITE(scatter_test)

using numerics::Estimate;
using numerics::fit_scattered_power;
using numerics::mean_of;
using numerics::Measured;
using numerics::ScatteredPower;
using tolerance::relative_difference;

BOOST_AUTO_TEST_CASE(the_mean_has_the_standard_error_that_python_gives) {
  // Python 3.11: statistics.mean(x), statistics.stdev(x)/sqrt(4)
  const Measured mean = mean_of({{1.31, 0.02}, {1.34, 0.01}, {1.29, 0.03}, {1.36, 0}}, "places");

  BOOST_TEST(relative_difference(mean.value(), 1.325) < 1e-14);
  BOOST_TEST(relative_difference(mean.standard(), 0.015545631755148039) < 1e-12);
  BOOST_TEST(relative_difference(mean.bounded().abs_error, 0.015) < 1e-12);
}

BOOST_AUTO_TEST_CASE(a_power_law_without_scatter_has_no_uncertainty) {
  std::vector<double> n;
  std::vector<Estimate> errors;
  for (int i = 0; i < 5; ++i) {
    n.push_back(2.385 * std::pow(1.7, i));
    errors.push_back({-0.613 * std::pow(n.back(), -1.5), 0});
  }

  const ScatteredPower power = fit_scattered_power(n, errors, "places");

  BOOST_TEST(relative_difference(power.order.value(), 1.5) < 1e-13);
  BOOST_TEST(relative_difference(power.factor.value(), 0.613) < 1e-13);
  BOOST_TEST(power.order.standard() < 1e-13);
}

BOOST_AUTO_TEST_CASE(scattered_errors_have_the_order_and_its_standard_error_of_python) {
  // Python 3.11: x, y = [log(n) …], [log(abs(error)) …]; statistics.linear_regression(x, y);
  // s = sqrt(sum(residual**2)/2), of the slope s/sqrt(Sxx), of the intercept s*sqrt(1/4 + x̄²/Sxx)
  const ScatteredPower power =
      fit_scattered_power({3, 7, 12, 31}, {{0.41, 0}, {-0.09, 0}, {0.055, 0}, {0.0071, 0}}, "s");

  BOOST_TEST(relative_difference(power.order.value(), 1.6983378085775298) < 1e-13);
  BOOST_TEST(relative_difference(std::log(power.factor.value()), 1.0188206165243483) < 1e-13);
  BOOST_TEST(relative_difference(power.order.standard(), 0.14774679679676136) < 1e-12);
  BOOST_TEST(relative_difference(power.factor.standard() / power.factor.value(),
                                 0.3539803622164045) < 1e-12);
}

BOOST_AUTO_TEST_CASE(bounds_of_the_errors_bound_the_order) {
  const std::vector<double> n = {10, 20, 40};
  const auto order = [&](double change) {
    return fit_scattered_power(n, {{0.1 + change, 0}, {0.03, 0}, {0.006 - change, 0}}, "s")
        .order.value();
  };

  const Measured bounded =
      fit_scattered_power(n, {{0.1, 5e-4}, {0.03, 0}, {0.006, 5e-4}}, "s").order;

  BOOST_TEST(std::abs(order(5e-4) - bounded.value()) <= bounded.bounded().abs_error);
  BOOST_TEST(std::abs(order(-5e-4) - bounded.value()) <= bounded.bounded().abs_error);
}

BOOST_AUTO_TEST_CASE(too_few_observations_and_errors_within_their_bounds_are_refused) {
  BOOST_CHECK_THROW(mean_of({{1, 0}}, "s"), sys::InvalidQuantity);
  BOOST_CHECK_THROW(fit_scattered_power({1, 2}, {{1, 0}, {2, 0}}, "s"), sys::InvalidQuantity);
  BOOST_CHECK_THROW(fit_scattered_power({1, 2}, {{1, 0}, {2, 0}, {3, 0}}, "s"),
                    sys::InvalidQuantity);
  BOOST_CHECK_THROW(fit_scattered_power({1, 2, 3}, {{1, 0}, {2, 0}, {3, 3}}, "s"),
                    sys::InvalidQuantity);
}

BOOST_AUTO_TEST_SUITE_END()
