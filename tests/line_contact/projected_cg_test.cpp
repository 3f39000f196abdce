// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_contact/projected_cg.hpp"

#include <Eigen/LU>
#include <boost/test/unit_test.hpp>
#include <string>

#include "line_contact/problem.hpp"
#include "numbers.hpp"
#include "system/require.hpp"

BOOST_AUTO_TEST_SUITE(projected_cg_test)

using contact::ContactMask;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using line_contact::Element;
using line_contact::influence_coefficient;
using line_contact::InfluenceOperator;
using line_contact::name_of;
using line_contact::Profile;
using line_contact::ProjectedCg;
using sys::InvalidQuantity;

namespace {

constexpr Element elements[] = {Element::point, Element::uniform, Element::triangular};

// Nodes on a parabola, some of them fixed in contact: a stretch with a gap in it, and a single
// node.
struct Held {
  explicit Held(Index n)
      : gap(VectorXd::NullaryExpr(n, [n](Index i) { return height(n, i); })),
        rises(gap.tail(n - 1) - gap.head(n - 1)),
        in_contact(ContactMask::Constant(n, false)) {
    in_contact.segment(n / 4, n / 2).setConstant(true);
    in_contact[n / 3] = false;
    in_contact[n - 2] = true;
  }
  static double height(Index n, Index i) {
    const double x = (static_cast<double>(i) - 0.4385 * static_cast<double>(n)) / 64;
    return x * x;
  }

  VectorXd guess(double total) const {
    const VectorXd phi = in_contact.cast<double>();
    return phi * (total / phi.sum());
  }

  VectorXd gap;
  VectorXd rises;
  ContactMask in_contact;
};

struct Dense {
  VectorXd phi;
  VectorXd gap;
};

// Eq. (1a) at the nodes in contact and Σφ = total by Gaussian elimination.
Dense solve_densely(Element element, const Held& held, double total) {
  const Index n = held.gap.size();
  MatrixXd matrix = MatrixXd::Zero(n + 1, n + 1);
  VectorXd right_side = VectorXd::Zero(n + 1);
  for (Index i = 0; i < n; ++i) {
    if (!held.in_contact[i]) {
      matrix(i, i) = 1;
      continue;
    }
    for (Index j = 0; j < n; ++j) {
      matrix(i, j) = influence_coefficient(element, static_cast<double>(i - j));
    }
    matrix(i, n) = 1;
    matrix(n, i) = 1;
    right_side[i] = held.gap[i];
  }
  right_side[n] = total;
  const VectorXd unknowns = matrix.partialPivLu().solve(right_side);

  Dense dense{unknowns.head(n), held.gap.array() - unknowns[n]};
  for (Index i = 0; i < n; ++i) {
    for (Index j = 0; j < n; ++j) {
      dense.gap[i] -= influence_coefficient(element, static_cast<double>(i - j)) * dense.phi[j];
    }
  }
  return dense;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_fixed_contact_is_solved_as_by_elimination) {
  const double total = 2.385;
  for (const Element element : elements) {
    for (const Index n : {12, 64, 201}) {
      const Held held(n);
      const Dense dense = solve_densely(element, held, total);
      InfluenceOperator influence(element, n);
      ProjectedCg pressures(influence, held.rises);
      VectorXd phi = held.guess(total);
      pressures.solve(phi, held.in_contact, 1e-13);

      BOOST_TEST_CONTEXT(name_of(element) << ", n = " << n) {
        BOOST_TEST((phi - dense.phi).cwiseAbs().maxCoeff() < 1e-12 * dense.phi.maxCoeff());
        BOOST_TEST((pressures.gap() - dense.gap).cwiseAbs().maxCoeff() < 1e-12 * total);
        BOOST_TEST(pressures.error() <= 1e-13);
        BOOST_TEST(tolerance::relative_difference(phi.sum(), total) < 1e-14);
        BOOST_TEST(held.in_contact.select(VectorXd::Zero(n), phi).cwiseAbs().maxCoeff() == 0);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(the_estimated_error_is_within_a_factor_of_five_of_the_true_one) {
  const Held held(150);
  const Dense dense = solve_densely(Element::triangular, held, 1);
  InfluenceOperator influence(Element::triangular, 150);
  for (const double tolerance : {1e-2, 1e-4, 1e-7, 1e-10}) {
    ProjectedCg pressures(influence, held.rises);
    VectorXd phi = held.guess(1);
    pressures.solve(phi, held.in_contact, tolerance);

    BOOST_TEST(pressures.error() <= tolerance);
    const double error = (phi - dense.phi).cwiseAbs().maxCoeff() / dense.phi.maxCoeff();
    BOOST_TEST(error < 5 * tolerance);
  }
}

BOOST_AUTO_TEST_CASE(steps_do_not_increase_with_the_number_of_nodes) {
  for (const Index n : {128, 1024, 8192}) {
    ContactMask in_contact = ContactMask::Constant(n, false);
    in_contact.segment(n / 5, n / 2).setConstant(true);
    const Profile parabola = Profile::parabola(2 / static_cast<double>(n));
    const VectorXd rises = VectorXd::NullaryExpr(n - 1, [&](Index i) {
      const auto x = static_cast<double>(i) - 0.45 * static_cast<double>(n);
      return parabola.rise(x, x + 1);
    });
    InfluenceOperator influence(Element::triangular, n);
    ProjectedCg pressures(influence, rises);
    VectorXd phi = in_contact.cast<double>();
    pressures.solve(phi, in_contact, 1e-10);

    BOOST_TEST(pressures.work().iterations <= 30);
  }
}

BOOST_AUTO_TEST_CASE(a_tolerance_below_rounding_is_an_error) {
  const Held held(100);
  InfluenceOperator influence(Element::triangular, 100);
  ProjectedCg pressures(influence, held.rises);
  VectorXd phi = held.guess(1);

  BOOST_CHECK_EXCEPTION(pressures.solve(phi, held.in_contact, 1e-19), InvalidQuantity,
                        [](const InvalidQuantity& e) {
                          return std::string(e.what()).find("the rounding error of the pressure") !=
                                 std::string::npos;
                        });
}

BOOST_AUTO_TEST_SUITE_END()
