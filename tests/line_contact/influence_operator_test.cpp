// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_contact/influence_operator.hpp"

#include <gsl/gsl_eigen.h>

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <vector>

#include "numbers.hpp"

BOOST_AUTO_TEST_SUITE(influence_operator_test)

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using line_contact::differences_over_grid;
using line_contact::Element;
using line_contact::influence_coefficient;
using line_contact::influence_difference;
using line_contact::InfluenceOperator;
using line_contact::name_of;

namespace {

constexpr Element elements[] = {Element::point, Element::uniform, Element::triangular};

VectorXd random_values(Index n, double low = -1) {
  RandomInputs random(static_cast<std::uint64_t>(n));
  return VectorXd::NullaryExpr(n, [&] { return random.uniform(low, 2.385); });
}

// T(k+1) − T(k) for any whole k.
double difference(Element element, Index k) {
  return k >= 0 ? influence_difference(element, k) : -influence_difference(element, -k - 1);
}

// Σ_j coefficient(i−j) φ_j for values that begin at `first`, in long double.
template <class Coefficient>
VectorXd dense_product(const Coefficient& coefficient, const VectorXd& phi, Index first,
                       Index n_rows) {
  VectorXd result(n_rows);
  for (Index i = 0; i < n_rows; ++i) {
    long double sum = 0;
    for (Index j = 0; j < phi.size(); ++j) {
      sum += static_cast<long double>(coefficient(i - first - j)) * phi[j];
    }
    result[i] = static_cast<double>(sum);
  }
  return result;
}

VectorXd dense_potentials(Element element, const VectorXd& phi) {
  const auto coefficient = [=](Index k) {
    return influence_coefficient(element, static_cast<double>(k));
  };
  return dense_product(coefficient, phi, 0, phi.size());
}

VectorXd dense_rises(Element element, const VectorXd& phi, Index first, Index n_nodes) {
  return dense_product([=](Index k) { return difference(element, k); }, phi, first, n_nodes - 1);
}

// A smooth load of n elements, like that of a contact.
VectorXd ellipse(Index n) {
  return VectorXd::NullaryExpr(n, [n](Index i) {
    const double t = (2 * static_cast<double>(i) + 1) / static_cast<double>(n) - 1;
    return std::sqrt(1 - t * t);
  });
}

// The real parts of a matrix's eigenvalues, in ascending order.
VectorXd eigenvalues_of(MatrixXd matrix) {
  const auto n = static_cast<std::size_t>(matrix.rows());
  auto view = gsl_matrix_view_array(matrix.data(), n, n);
  std::vector<double> pairs(2 * n);  // real and imaginary parts
  auto values = gsl_vector_complex_view_array(pairs.data(), n);
  gsl_eigen_nonsymm_workspace* workspace = gsl_eigen_nonsymm_alloc(n);
  const int status = gsl_eigen_nonsymm(&view.matrix, &values.vector, workspace);
  gsl_eigen_nonsymm_free(workspace);
  BOOST_TEST_REQUIRE(status == 0);
  VectorXd real(matrix.rows());
  for (std::size_t i = 0; i < n; ++i) real[static_cast<Index>(i)] = pairs[2 * i];
  std::sort(real.begin(), real.end());
  return real;
}

MatrixXd preconditioner(Element element, Index n) {
  InfluenceOperator influence(element, n);
  MatrixXd matrix(n, n);
  VectorXd column;
  for (Index j = 0; j < n; ++j) {
    influence.precondition(VectorXd::Unit(n, j), column);
    matrix.col(j) = column;
  }
  return matrix;
}

}  // namespace

BOOST_AUTO_TEST_CASE(potentials_and_differences_are_the_dense_products) {
  for (const Element element : elements) {
    for (const Index n : {1, 2, 3, 5, 31, 64, 100, 385}) {
      const VectorXd phi = random_values(n);
      InfluenceOperator influence(element, n);
      VectorXd potentials, rises;
      influence.potentials(phi, potentials);
      BOOST_TEST_CONTEXT(name_of(element) << ", n = " << n) {
        BOOST_TEST((potentials - dense_potentials(element, phi)).cwiseAbs().maxCoeff() <
                   2 * tolerance::rounding * phi.cwiseAbs().sum());
        if (n == 1) continue;
        influence.differences(phi, rises);
        BOOST_TEST((rises - dense_rises(element, phi, 0, n)).cwiseAbs().maxCoeff() <
                   tolerance::rounding * std::sqrt(static_cast<double>(n)) * phi.norm());
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(differences_keep_the_digits_that_subtracting_potentials_loses) {
  constexpr Index n = 4096;
  const VectorXd phi = ellipse(n);
  for (const Element element : elements) {
    InfluenceOperator influence(element, n);
    VectorXd rises, potentials;
    influence.differences(phi, rises);
    influence.potentials(phi, potentials);
    const VectorXd differences = potentials.tail(n - 1) - potentials.head(n - 1);
    const VectorXd exact = dense_rises(element, phi, 0, n);
    const double of_rises = (rises - exact).cwiseAbs().maxCoeff();
    const double of_differences = (differences - exact).cwiseAbs().maxCoeff();

    BOOST_TEST(of_rises < 1e-14);  // of rises up to 3
    BOOST_TEST(of_differences > 100 * of_rises);
  }
}

BOOST_AUTO_TEST_CASE(the_preconditioner_is_symmetric_and_positive_semi_definite) {
  for (const Element element : elements) {
    for (const Index n : {1, 2, 5, 24, 77, 160}) {
      const MatrixXd matrix = preconditioner(element, n);
      const double scale = matrix.diagonal().maxCoeff();
      const VectorXd eigenvalues = eigenvalues_of(matrix);

      BOOST_TEST_CONTEXT(name_of(element) << ", n = " << n) {
        BOOST_TEST((matrix - matrix.transpose()).cwiseAbs().maxCoeff() < 1e-14 * scale);
        BOOST_TEST(eigenvalues.minCoeff() > -1e-14 * scale);
        BOOST_TEST(scale > 0);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(the_preconditioner_is_an_inverse_except_in_a_few_directions_at_any_n) {
  // The eigenvalues of −PT on loads without a resultant; those far from 1 come from the ends.
  for (const Element element : elements) {
    for (const Index n : {32, 64, 128}) {
      const MatrixXd inverse = preconditioner(element, n);
      const MatrixXd compliance = MatrixXd::NullaryExpr(n, n, [=](Index i, Index j) {
        return -influence_coefficient(element, static_cast<double>(i - j));
      });
      const MatrixXd without_mean =
          MatrixXd::Identity(n, n) - MatrixXd::Constant(n, n, 1 / static_cast<double>(n));
      const VectorXd eigenvalues =
          eigenvalues_of(without_mean * inverse * without_mean * compliance * without_mean);
      const auto is_far_from_1 = [](double value) { return std::abs(value - 1) > 0.1; };

      BOOST_TEST_CONTEXT(name_of(element) << ", n = " << n) {
        BOOST_TEST(eigenvalues[1] > 0.4);  // eigenvalues[0] = 0 belongs to the mean
        BOOST_TEST(eigenvalues[n - 1] < 3.5);
        BOOST_TEST(std::count_if(eigenvalues.begin() + 1, eigenvalues.end(), is_far_from_1) <= 9);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(differences_over_a_grid_are_dense_products_wherever_the_window_lies) {
  struct Window {
    Index first, n, n_nodes;
  };
  const Window windows[] = {{0, 5, 5},      {0, 1, 7},        {6, 1, 7},    {3, 17, 20},
                            {0, 17, 20},    {2, 17, 20},      {7, 3, 1000}, {990, 7, 1000},
                            {997, 3, 1000}, {400, 200, 1000}, {0, 3, 1000}, {0, 999, 1000},
                            {1, 999, 1000}};
  for (const Element element : elements) {
    for (const Window& window : windows) {
      const VectorXd phi = random_values(window.n);
      const VectorXd rises = differences_over_grid(element, phi, window.first, window.n_nodes);

      BOOST_TEST_CONTEXT(name_of(element) << ", " << window.n << " of " << window.n_nodes
                                          << " from " << window.first) {
        BOOST_TEST(rises.size() == window.n_nodes - 1);
        const VectorXd exact = dense_rises(element, phi, window.first, window.n_nodes);
        BOOST_TEST((rises - exact).cwiseAbs().maxCoeff() <
                   tolerance::rounding * std::sqrt(static_cast<double>(window.n_nodes)) *
                       phi.norm());
      }
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
