// SPDX-License-Identifier: GPL-3.0-or-later
#include "numerics/fit.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>

#include "numbers.hpp"
#include "refused.hpp"

BOOST_AUTO_TEST_SUITE(fit_test)

using Eigen::MatrixXd;
using Eigen::VectorXd;
using numerics::fit;
using numerics::Fit;
using numerics::fit_power;
using tolerance::relative_difference;

namespace {

// A straight line c₀ + c₁ x at x = 1 … n.
MatrixXd line(Eigen::Index n) {
  MatrixXd matrix(n, 2);
  matrix.col(0).setOnes();
  matrix.col(1).setLinSpaced(1, static_cast<double>(n));
  return matrix;
}

}  // namespace

// Norris, certified by NIST's Statistical Reference Datasets (36 observations of a straight line,
// https://www.itl.nist.gov/div898/strd/lls/data/Norris.shtml).
BOOST_AUTO_TEST_CASE(a_straight_line_has_the_certified_coefficients_of_nist) {
  const double y[] = {0.1,   338.8, 118.1, 888.0, 9.2,   228.1, 668.5, 998.5, 449.1,
                      778.9, 559.2, 0.3,   0.1,   778.1, 668.8, 339.3, 448.9, 10.8,
                      557.7, 228.3, 998.0, 888.8, 119.6, 0.3,   0.6,   557.6, 339.3,
                      888.0, 998.5, 778.9, 10.2,  117.6, 228.9, 668.4, 449.2, 0.2};
  const double x[] = {0.2,   337.4, 118.2, 884.6, 10.1,  226.5, 666.3, 996.3, 448.6,
                      777.0, 558.2, 0.4,   0.6,   775.5, 666.9, 338.0, 447.5, 11.6,
                      556.0, 228.1, 995.8, 887.6, 120.2, 0.3,   0.3,   556.8, 339.1,
                      887.2, 999.0, 779.0, 11.1,  118.3, 229.2, 669.1, 448.9, 0.5};
  MatrixXd matrix(36, 2);
  matrix.col(0).setOnes();
  matrix.col(1) = Eigen::Map<const VectorXd>(x, 36);
  const Fit found = fit(matrix, Eigen::Map<const VectorXd>(y, 36));

  BOOST_TEST(relative_difference(found.coefficients[0], -0.262323073774029) < 1e-12);
  BOOST_TEST(relative_difference(found.coefficients[1], 1.00211681802045) < 1e-13);
  BOOST_TEST(relative_difference(found.standard(0), 0.232818234301152) < 1e-12);
  BOOST_TEST(relative_difference(found.standard(1), 0.429796848199937e-3) < 1e-12);
  BOOST_TEST(relative_difference(found.chi_squared, 26.6173985294224) < 1e-12);
  BOOST_TEST(found.degrees_of_freedom == 34);
}

BOOST_AUTO_TEST_CASE(known_uncertainties_give_the_covariance_whatever_the_residuals) {
  const MatrixXd matrix = line(5);
  const VectorXd standard = (VectorXd(5) << 0.1, 0.2, 0.3, 0.2, 0.7).finished();
  const MatrixXd expected =
      (matrix.transpose() * standard.array().square().inverse().matrix().asDiagonal() * matrix);
  for (const double scatter : {0.0, 5.0}) {
    VectorXd y = matrix * Eigen::Vector2d(2.385, -0.7);
    y[2] += scatter;
    const Fit found = fit(matrix, y, standard);
    BOOST_TEST((found.covariance * expected - MatrixXd::Identity(2, 2)).norm() < 1e-12);
    BOOST_TEST((found.residuals - (y - matrix * found.coefficients)).norm() < 1e-13);
    BOOST_TEST(std::abs(found.chi_squared -
                        (found.residuals.array() / standard.array()).square().sum()) < 1e-10);
  }
}

BOOST_AUTO_TEST_CASE(the_standard_uncertainty_matches_the_scatter_of_fits_to_noise) {
  RandomInputs random(5);
  const MatrixXd matrix = line(12);
  double squares = 0, claimed = 0;
  constexpr int n_fits = 4000;
  for (int i = 0; i < n_fits; ++i) {
    const VectorXd noise = VectorXd::NullaryExpr(12, [&] { return 0.3 * random.normal(); });
    const Fit found = fit(matrix, VectorXd(matrix * Eigen::Vector2d(1, 2) + noise));
    squares += std::pow(found.coefficients[1] - 2, 2) / n_fits;
    claimed += std::pow(found.standard(1), 2) / n_fits;
  }
  BOOST_TEST(relative_difference(claimed, squares) < 0.1);
}

BOOST_AUTO_TEST_CASE(a_power_law_is_recovered_with_its_scatter) {
  std::vector<double> n, errors;
  for (int k = 0; k < 8; ++k) {
    n.push_back(std::ldexp(10.0, k));
    errors.push_back((k % 2 == 0 ? -1.1 : 1 / 1.1) * 2.385 * std::pow(n.back(), -1.75));
  }
  const numerics::PowerLaw law = fit_power(n, errors);
  BOOST_TEST(std::abs(law.order - 1.75) < 2 * law.order_standard);
  BOOST_TEST(law.order_standard < 0.05);

  for (double& error : errors) error = std::pow(error, 0) * 3;
  BOOST_TEST(std::abs(fit_power(n, errors).order) < 1e-14);
}

BOOST_AUTO_TEST_CASE(invalid_fits_are_rejected) {
  MatrixXd dependent = line(4);
  dependent.col(1) = 3 * dependent.col(0);
  MatrixXd infinite = line(4);
  infinite(1, 1) = std::numeric_limits<double>::infinity();
  const VectorXd y = VectorXd::Ones(4);
  check_refused({
      {"number of coefficients of a fit = 0", [&] { fit(MatrixXd(4, 0), y); }},
      {"number of observations = 3", [&] { fit(line(4), VectorXd::Ones(3)); }},
      {"number of observations = 1", [&] { fit(line(1), VectorXd::Ones(1)); }},
      {"number of independent columns of a fit = 1", [&] { fit(dependent, y); }},
      {"entry of the matrix", [&] { fit(infinite, y); }},
      {"observation", [&] { fit(line(4), VectorXd::Constant(4, NAN)); }},
      {"number of standard uncertainties", [&] { fit(line(4), y, VectorXd::Ones(3)); }},
      {"standard uncertainty = 0", [&] { fit(line(4), y, VectorXd::Zero(4)); }},
      {"number of errors = 2",
       [] {
         fit_power({1, 2}, {1, 2});
       }},
      {"number of abscissae = 2",
       [] {
         fit_power({1, 2}, {1, 2, 3});
       }},
      {"magnitude of an error = 0",
       [] {
         fit_power({1, 2, 3}, {1, 0, 3});
       }},
      {"abscissa = -2",
       [] {
         fit_power({1, -2, 3}, {1, 1, 3});
       }},
  });
}

BOOST_AUTO_TEST_SUITE_END()
