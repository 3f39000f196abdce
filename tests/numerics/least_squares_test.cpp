// SPDX-License-Identifier: GPL-3.0-or-later
#include "numerics/least_squares.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>
#include <tuple>

#include "message_of.hpp"
#include "random_inputs.hpp"
#include "system/require.hpp"

BOOST_AUTO_TEST_SUITE(least_squares_test)

using boost::test_tools::tolerance;
using Eigen::MatrixXd;
using numerics::correlated;
using numerics::correlation;
using numerics::covariance;
using numerics::fit_linear;
using numerics::Measured;
using sys::InvalidQuantity;

namespace {

// 1 and x for a straight line.
MatrixXd straight(const std::vector<double>& x) {
  MatrixXd matrix(static_cast<Eigen::Index>(x.size()), 2);
  matrix.col(0).setOnes();
  std::copy(x.begin(), x.end(), matrix.col(1).begin());
  return matrix;
}

Measured point(double value, double standard, int n) {
  return {value, standard, "point " + std::to_string(n)};
}

// Pearson's data with York's weights, 1/u² of y (D. York, Can. J. Phys. 44, 1966, 1079).
const std::vector<double> pearson_x{0, 0.9, 1.8, 2.6, 3.3, 4.4, 5.2, 6.1, 6.5, 7.4};
const std::vector<double> pearson_y{5.9, 5.4, 4.4, 4.6, 3.5, 3.7, 2.8, 2.8, 2.4, 1.5};
const std::vector<double> york_weight{1, 1.8, 4, 8, 20, 20, 70, 70, 100, 500};

std::vector<Measured> pearson() {
  std::vector<Measured> observed;
  for (std::size_t i = 0; i < pearson_y.size(); ++i) {
    observed.push_back(point(pearson_y[i], 1 / std::sqrt(york_weight[i]), static_cast<int>(i)));
  }
  return observed;
}

}  // namespace

// The normal equations of a straight line, solved by hand: with the weighted sums S, Sx, Sxx, Sy
// and Sxy and D = S Sxx − Sx², c₀ = (Sxx Sy − Sx Sxy)/D, c₁ = (S Sxy − Sx Sy)/D, and the covariance
// is {Sxx, −Sx; −Sx, S}/D.
BOOST_AUTO_TEST_CASE(a_weighted_line_has_the_covariance_of_the_normal_equations) {
  double s = 0, sx = 0, sxx = 0, sy = 0, sxy = 0;
  for (std::size_t i = 0; i < pearson_x.size(); ++i) {
    const double x = pearson_x[i], y = pearson_y[i], w = york_weight[i];
    s += w, sx += w * x, sxx += w * x * x, sy += w * y, sxy += w * x * y;
  }
  const double d = s * sxx - sx * sx;
  const auto fit = fit_linear(straight(pearson_x), pearson());
  const Measured& c0 = fit.coefficients[0];
  const Measured& c1 = fit.coefficients[1];
  BOOST_TEST(c0.value() == (sxx * sy - sx * sxy) / d, tolerance(1e-12));
  BOOST_TEST(c1.value() == (s * sxy - sx * sy) / d, tolerance(1e-12));
  BOOST_TEST(c0.standard() == std::sqrt(sxx / d), tolerance(1e-12));
  BOOST_TEST(c1.standard() == std::sqrt(s / d), tolerance(1e-12));
  BOOST_TEST(covariance(c0, c1) == -sx / d, tolerance(1e-12));
  double chi_squared = 0;
  for (std::size_t i = 0; i < pearson_x.size(); ++i) {
    chi_squared +=
        york_weight[i] * std::pow(pearson_y[i] - c0.value() - c1.value() * pearson_x[i], 2);
  }
  BOOST_TEST(fit.chi_squared.value() == chi_squared, tolerance(1e-10));
  BOOST_TEST(fit.degrees_of_freedom == 8);
}

// What the line says at a point has less uncertainty than its coefficients apart would give it.
BOOST_AUTO_TEST_CASE(a_fitted_line_is_surest_at_the_middle_of_its_points) {
  const auto fit =
      fit_linear(straight({-1, 0, 1}), {point(1, 0.3, 1), point(2, 0.3, 2), point(3, 0.3, 3)});
  const Measured& c0 = fit.coefficients[0];
  const Measured& c1 = fit.coefficients[1];
  BOOST_TEST(c0.standard() == 0.3 / std::sqrt(3), tolerance(1e-12));
  BOOST_TEST(std::abs(correlation(c0, c1)) < 1e-14);
  BOOST_TEST((c0 + 2 * c1).standard() == 0.3 * std::sqrt(1. / 3 + 4. / 2), tolerance(1e-12));
  for (const double residual : fit.residuals) BOOST_TEST(std::abs(residual) < 1e-14);
}

BOOST_AUTO_TEST_CASE(what_the_observations_have_in_common_moves_the_whole_line) {
  const Measured scale(0, 0.5, "zero of the scale");
  const auto fit =
      fit_linear(straight({0, 1, 2, 3}), {point(1, 0.1, 1) + scale, point(2, 0.1, 2) + scale,
                                          point(3, 0.1, 3) + scale, point(4, 0.1, 4) + scale});
  BOOST_TEST(fit.coefficients[0].components().at("zero of the scale") == 0.5, tolerance(1e-12));
  BOOST_TEST(!fit.coefficients[1].kinds().contains("zero of the scale"));
}

// The worst data within the bounds, found by trying all their signs.
BOOST_AUTO_TEST_CASE(bounded_observations_leave_the_range_that_the_worst_of_them_reach) {
  const std::vector<double> x{0, 1, 2, 4, 5}, y{1, 2, 2, 5, 7}, bound{0.1, 0.2, 0.1, 0.3, 0.1};
  const auto fitted = [&](unsigned signs, bool is_moved) {
    std::vector<Measured> observed;
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double sign = (signs >> i & 1U) != 0 ? 1 : -1;
      observed.push_back(is_moved ? Measured(y[i] + sign * bound[i])
                                  : Measured::bounded({y[i], bound[i]}));
    }
    return fit_linear(straight(x), observed);
  };
  const auto fit = fitted(0, false);
  BOOST_TEST(!fit.chi_squared.has_value());
  for (std::size_t j = 0; j < 2; ++j) {
    double worst = 0;
    for (unsigned signs = 0; signs < 32; ++signs) {
      worst = std::max(worst, std::abs(fitted(signs, true).coefficients[j].value() -
                                       fit.coefficients[j].value()));
    }
    BOOST_TEST(fit.coefficients[j].standard() == 0);
    BOOST_TEST(fit.coefficients[j].bounded().abs_error == worst, tolerance(1e-12));
  }
}

BOOST_AUTO_TEST_CASE(fits_of_drawn_data_scatter_as_the_covariance_says) {
  const std::vector<double> x{0, 1, 2, 3, 4, 5, 6, 7};
  RandomInputs random(7);
  double sum_00 = 0, sum_11 = 0, sum_01 = 0, sum_of_chi = 0;
  constexpr int n_draws = 20'000;
  Measured c0 = 0, c1 = 0;
  for (int n = 0; n < n_draws; ++n) {
    std::vector<Measured> observed;
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double u = 0.1 * (1 + x[i]);
      observed.push_back(point(3 - 2 * x[i] + u * random.normal(), u, static_cast<int>(i)));
    }
    const auto fit = fit_linear(straight(x), observed);
    c0 = fit.coefficients[0], c1 = fit.coefficients[1];
    sum_00 += std::pow(c0.value() - 3, 2);
    sum_11 += std::pow(c1.value() + 2, 2);
    sum_01 += (c0.value() - 3) * (c1.value() + 2);
    sum_of_chi += fit.chi_squared.value();
  }
  const double scatter = 5 * std::sqrt(2. / n_draws);
  BOOST_TEST(sum_00 / n_draws == c0.standard() * c0.standard(), tolerance(scatter));
  BOOST_TEST(sum_11 / n_draws == c1.standard() * c1.standard(), tolerance(scatter));
  BOOST_TEST(sum_01 / n_draws == covariance(c0, c1), tolerance(2 * scatter));
  BOOST_TEST(sum_of_chi / n_draws == 6, tolerance(scatter));
}

BOOST_AUTO_TEST_CASE(numbers_with_a_covariance_have_it_again) {
  MatrixXd c(3, 3);
  c << 4, 1, -0.5, 1, 2, 0.3, -0.5, 0.3, 1;
  const auto numbers = correlated({1, 2, 3}, c, "calibration/sphere");
  for (Eigen::Index i = 0; i < 3; ++i) {
    for (Eigen::Index j = 0; j < 3; ++j) {
      BOOST_TEST(covariance(numbers[static_cast<std::size_t>(i)],
                            numbers[static_cast<std::size_t>(j)]) == c(i, j),
                 tolerance(1e-13));
    }
  }
  BOOST_TEST(numbers[0].kinds().at("calibration") == 2, tolerance(1e-13));
}

// u + 2v from u and v, whose covariance has rank two: an example of the manual of the Python
// package uncertainties.
BOOST_AUTO_TEST_CASE(a_covariance_may_be_singular) {
  MatrixXd c(3, 3);
  c << 0.0025, 0, 0.0025, 0, 0.01, 0.02, 0.0025, 0.02, 0.0425;
  const auto numbers = correlated({1, 10, 21}, c, "fit");
  BOOST_TEST((numbers[2] - (numbers[0] + 2 * numbers[1])).standard() < 1e-8);
}

BOOST_AUTO_TEST_CASE(refuses_what_is_no_fit_and_no_covariance) {
  const auto line = straight({0, 1});
  BOOST_CHECK_NO_THROW(fit_linear(line, {1.0, 2.0}));
  BOOST_CHECK_THROW(fit_linear(line, {1.0}), InvalidQuantity);
  BOOST_CHECK_THROW(fit_linear(straight({0}), {1.0}), InvalidQuantity);
  BOOST_CHECK_THROW(fit_linear(MatrixXd(2, 0), {1.0, 2.0}), InvalidQuantity);
  BOOST_CHECK_THROW(fit_linear(straight({3, 3}), {1.0, 2.0}), InvalidQuantity);
  BOOST_CHECK_THROW(fit_linear(straight({3, NAN}), {1.0, 2.0}), InvalidQuantity);
  BOOST_CHECK_THROW(fit_linear(line, {1.0, point(2, 0.1, 1)}), InvalidQuantity);
  MatrixXd negative(2, 2), skew(2, 2);
  negative << 1, 2, 2, 1;
  skew << 1, 0.5, 0.4, 1;
  BOOST_CHECK_THROW(correlated({1, 2}, negative, "fit"), InvalidQuantity);
  BOOST_CHECK_THROW(correlated({1, 2}, skew, "fit"), InvalidQuantity);
  BOOST_CHECK_THROW(correlated({1}, negative, "fit"), InvalidQuantity);
  BOOST_CHECK_THROW(correlated({1, 2}, MatrixXd::Constant(2, 2, NAN), "fit"), InvalidQuantity);
}

// y = c₀ + c₁x with c₀ + c₁ held at s is y − s x = c₀ (1 − x), one coefficient.
BOOST_AUTO_TEST_CASE(a_coefficient_given_the_sum_of_both_is_that_of_the_fit_with_the_sum_held) {
  const std::vector<double> x{0, 1, 2, 4};
  const std::vector<Measured> y{point(1.1, 0.1, 1), point(1.9, 0.2, 2), point(3.2, 0.1, 3),
                                point(4.9, 0.3, 4)};
  const double s = 2.1;
  Eigen::MatrixXd column(4, 1);
  std::vector<Measured> reduced;
  for (std::size_t i = 0; i < x.size(); ++i) {
    column(static_cast<Eigen::Index>(i), 0) = 1 - x[i];
    reduced.push_back(y[i] - s * x[i]);
  }

  const auto free = fit_linear(straight(x), y).coefficients;
  const Measured held = fit_linear(column, reduced).coefficients[0];

  const Measured given_sum = given(free[0], free[0] + free[1], s);
  BOOST_TEST(given_sum.value() == held.value(), tolerance(1e-12));
  BOOST_TEST(given_sum.standard() == held.standard(), tolerance(1e-12));
  BOOST_CHECK_THROW(given(free[0], 2, s), sys::InvalidQuantity);
}

BOOST_AUTO_TEST_CASE(a_fit_whose_squares_overflow_is_refused_by_its_greatest_number) {
  for (const auto& [y, u, greatest] : {std::tuple{1e300, 0.0, "1e+300"},
                                       {1e300, 1.0, "1e+300"},
                                       {1e300, 1e200, "1e+300"},
                                       {1.0, 1e-200, "2e+200"}}) {
    const std::vector<Measured> observed{{y, u, "a"}, {-y, u, "b"}, {y, u, "c"}};
    const std::string refusal = fmt::format(
        "greatest observation or weighted entry of a fit = {}: must be smaller, as "
        "squares of such numbers overflow",
        greatest);
    BOOST_TEST(message_of<InvalidQuantity>([&] {
                 fit_linear(straight({0, 1, 2}), observed);
               }) == refusal);
  }
}

BOOST_AUTO_TEST_SUITE_END()
