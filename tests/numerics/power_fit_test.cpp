// SPDX-License-Identifier: GPL-3.0-or-later
#include "numerics/power_fit.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <random>
#include <vector>

#include "system/require.hpp"
#include "tolerances.hpp"

BOOST_AUTO_TEST_SUITE(power_fit_test)

using numerics::fit_power;
using numerics::PowerFit;
using tolerance::relative_difference;

BOOST_AUTO_TEST_CASE(a_power_law_gives_its_own_order_and_factor) {
  std::vector<double> n, errors;
  for (int i = 0; i < 7; ++i) {
    n.push_back(2.385 * std::pow(1.7, i));
    errors.push_back(0.613 * std::pow(n.back(), -1.5) * (i % 2 == 0 ? 1 : -1));
  }

  const PowerFit power = fit_power(n, errors);

  BOOST_TEST(relative_difference(power.order.value, 1.5) < 1e-13);
  BOOST_TEST(relative_difference(power.factor.value, 0.613) < 1e-13);
}

BOOST_AUTO_TEST_CASE(scattered_errors_have_the_order_that_python_fits) {
  // Python 3.11: statistics.linear_regression([log(n) …], [log(abs(error)) …])
  const PowerFit power = fit_power({3, 7, 12, 31}, {0.41, -0.09, 0.055, 0.0071});

  BOOST_TEST(relative_difference(power.order.value, 1.6983378085775298) < 1e-13);
  BOOST_TEST(relative_difference(std::log(power.factor.value), 1.0188206165243483) < 1e-13);
}

BOOST_AUTO_TEST_CASE(twenty_errors_are_fitted_in_bins_of_ten_by_their_root_mean_square) {
  // In each ten errors nine are zero, whose logarithm is infinite, and one is √10/n.
  std::vector<double> n, errors;
  for (int i = 0; i < 29; ++i) {
    n.push_back(i < 10 ? 2 : 8);
    errors.push_back(i % 10 == 3 ? std::sqrt(10) / n.back() : 0);
  }

  const PowerFit power = fit_power(n, errors);

  BOOST_TEST(relative_difference(power.order.value, 1) < 1e-14);
  BOOST_TEST(relative_difference(power.factor.value, 1) < 1e-14);
}

BOOST_AUTO_TEST_CASE(fewer_than_two_errors_and_lists_of_different_lengths_are_refused) {
  BOOST_CHECK_THROW(fit_power({}, {}), sys::InvalidQuantity);
  BOOST_CHECK_THROW(fit_power({1}, {1}), sys::InvalidQuantity);
  BOOST_CHECK_THROW(fit_power({1, 2, 3}, {1, 2}), sys::InvalidQuantity);
  BOOST_CHECK_THROW(fit_power({1, 2}, {1, 2}, {1}), sys::InvalidQuantity);
}

BOOST_AUTO_TEST_CASE(order_and_factor_of_a_fit_move_by_no_more_than_their_errors) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (const std::size_t n_grids : {4U, 30U}) {
    std::vector<double> n, errors, bounds;
    for (std::size_t i = 0; i < n_grids; ++i) {
      n.push_back(10 * std::pow(1.3, static_cast<double>(i)));
      errors.push_back((2 + uniform(random)) / (n.back() * n.back()));
      bounds.push_back(0.1 * errors.back());
    }
    const PowerFit power = fit_power(n, errors, bounds);
    BOOST_TEST(power.order.abs_error > 0.01);
    BOOST_TEST(power.order.abs_error < 0.5);
    BOOST_TEST(fit_power(n, errors).order.abs_error < 1e-13);
    // The logarithm of the factor rounds by m ε times the condition of the fit, 20 to 60 here.
    BOOST_TEST(fit_power(n, errors).factor.abs_error < 1e-12);
    // Of errors that are no more than their bounds the order is as good as unknown.
    BOOST_TEST(fit_power(n, errors, errors).order.abs_error > 1);
    BOOST_TEST(std::isfinite(fit_power(n, errors, errors).order.abs_error));
    for (int trial = 0; trial < 500; ++trial) {
      std::vector<double> moved = errors;
      for (std::size_t i = 0; i < n_grids; ++i)
        moved[i] += bounds[i] * std::copysign(1, uniform(random));
      const PowerFit again = fit_power(n, moved);
      BOOST_TEST(std::abs(again.order.value - power.order.value) <= power.order.abs_error);
      BOOST_TEST(std::abs(again.factor.value - power.factor.value) <= power.factor.abs_error);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
