// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/influence_operator.hpp"

#include <Eigen/LU>
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "numbers.hpp"
#include "point_contact/cases.hpp"

BOOST_AUTO_TEST_SUITE(influence_operator_test)

using namespace point_cases;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using point_contact::InfluenceOperator;
using point_contact::name_of;

namespace {

constexpr std::pair<Index, Index> sizes[] = {{1, 1}, {2, 3}, {8, 8}, {9, 7}, {5, 12}, {17, 16}};

VectorXd random_values(Index n) {
  RandomInputs random(static_cast<std::uint64_t>(n));
  return VectorXd::NullaryExpr(n, [&] { return random.uniform(-1, 2.385); });
}

MatrixXd dense(Element element, Index n1, Index n2) {
  return MatrixXd::NullaryExpr(n1 * n2, n1 * n2, [=](Index row, Index column) {
    return influence_coefficient(element, {static_cast<double>(row % n1 - column % n1),
                                           static_cast<double>(row / n1 - column / n1)});
  });
}

MatrixXd preconditioner(Element element, Index n1, Index n2) {
  InfluenceOperator influence(element, n1, n2);
  MatrixXd matrix(n1 * n2, n1 * n2);
  VectorXd column;
  for (Index j = 0; j < n1 * n2; ++j) {
    influence.precondition(VectorXd::Unit(n1 * n2, j), column);
    matrix.col(j) = column;
  }
  return matrix;
}

}  // namespace

BOOST_AUTO_TEST_CASE(displacements_are_the_dense_products_even_in_place) {
  for (const Element element : elements) {
    for (const auto& [n1, n2] : sizes) {
      InfluenceOperator influence(element, n1, n2);
      VectorXd phi = random_values(n1 * n2);
      const VectorXd expected = dense(element, n1, n2) * phi;
      VectorXd displacements;
      influence.displacements(phi, displacements);
      influence.displacements(phi, phi);
      BOOST_TEST_CONTEXT(name_of(element) << ", " << n1 << " x " << n2) {
        BOOST_TEST((displacements - expected).cwiseAbs().maxCoeff() <
                   1e-14 * expected.cwiseAbs().maxCoeff());
        BOOST_TEST((phi == displacements));
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(the_preconditioner_is_symmetric_positive_and_nearly_the_inverse) {
  for (const Element element : elements) {
    const MatrixXd matrix = preconditioner(element, 16, 12);
    const double scale = matrix.diagonal().maxCoeff();
    BOOST_TEST((matrix - matrix.transpose()).cwiseAbs().maxCoeff() < 1e-14 * scale);
    RandomInputs random(3);
    for (int i = 0; i < 20; ++i) {
      const VectorXd v = random_values(16 * 12).array() - random.uniform(0, 1);
      BOOST_TEST(v.dot(matrix * v) > 0);
    }
    // Away from the sides, a wave is unchanged.
    const VectorXd wave = VectorXd::NullaryExpr(16 * 12, [](Index k) {
      const double x = static_cast<double>(k % 16) - 7.5, y = static_cast<double>(k / 16) - 5.5;
      return std::exp(-(x * x + y * y) / 8) * std::cos(2.1 * x - 1.3 * y);
    });
    const VectorXd there_and_back = matrix * (dense(element, 16, 12) * wave);
    BOOST_TEST((there_and_back - wave).norm() < 0.1 * wave.norm());
  }
}

BOOST_AUTO_TEST_SUITE_END()
