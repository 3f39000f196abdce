// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/contact_search.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <cstdint>
#include <initializer_list>

#include "numbers.hpp"

BOOST_AUTO_TEST_SUITE(contact_search_test)

using contact::ContactMask;
using contact::ContactSearch;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

ContactMask mask(std::initializer_list<bool> values) {
  ContactMask result(static_cast<Index>(values.size()));
  std::copy(values.begin(), values.end(), result.begin());
  return result;
}

VectorXd vector(std::initializer_list<double> values) {
  VectorXd result(static_cast<Index>(values.size()));
  std::copy(values.begin(), values.end(), result.begin());
  return result;
}

// Finds φ ≥ 0 with the gap Mφ + q ≥ 0 and φ·gap = 0.
struct Complementarity {
  MatrixXd matrix;
  VectorXd q;

  VectorXd phi(const ContactMask& in_contact) const {
    MatrixXd equations = matrix;
    VectorXd right_side = -q;
    for (Index i = 0; i < q.size(); ++i) {
      if (in_contact[i]) continue;
      equations.row(i).setZero();
      equations(i, i) = 1;
      right_side[i] = 0;
    }
    return equations.partialPivLu().solve(right_side);
  }
  VectorXd gap(const VectorXd& phi) const { return matrix * phi + q; }
};

// Murty's matrix: all its principal minors are positive, but changing all wrong nodes at once
// cycles from {1,2} to {2,3}, {1,3} and back (Murty 1988, Linear Complementarity, p. 3.2: q = −1).
const Complementarity murty{(MatrixXd(3, 3) << 1, 2, 0, 0, 1, 2, 2, 0, 1).finished(),
                            vector({-1, -1, -1})};

bool change_all_that_is_wrong(const Complementarity& problem, ContactMask& in_contact) {
  const VectorXd phi = problem.phi(in_contact);
  const VectorXd gap = problem.gap(phi);
  bool changed = false;
  for (Index i = 0; i < phi.size(); ++i) {
    if (in_contact[i] ? phi[i] > 0 : gap[i] >= 0) continue;
    in_contact[i] = !in_contact[i];
    changed = true;
  }
  return changed;
}

}  // namespace

BOOST_AUTO_TEST_CASE(tension_leaves_and_penetration_enters) {
  ContactSearch search;
  ContactMask in_contact = mask({true, true, false, false, true});

  const bool settled =
      search.revise(in_contact, vector({1, -0.5, 0, 0, 2}), vector({0, 0, -0.3, 0.2, 0}), 0);

  BOOST_TEST(!settled);
  BOOST_TEST((in_contact == mask({true, false, true, false, true})).all());
}

BOOST_AUTO_TEST_CASE(a_node_without_pressure_is_not_in_contact) {
  ContactSearch search;
  ContactMask in_contact = mask({true, true});

  BOOST_TEST(!search.revise(in_contact, vector({0, 1}), vector({0, 0}), 0));
  BOOST_TEST((in_contact == mask({false, true})).all());
}

BOOST_AUTO_TEST_CASE(penetration_up_to_the_smallest_gap_is_ignored) {
  ContactMask in_contact = mask({true, false, false});
  const VectorXd phi = vector({1, 0, 0});

  BOOST_TEST(ContactSearch().revise(in_contact, phi, vector({0, -0.25, 1}), 0.25));
  BOOST_TEST(!ContactSearch().revise(in_contact, phi, vector({0, -0.2501, 1}), 0.25));
  BOOST_TEST((in_contact == mask({true, true, false})).all());
}

BOOST_AUTO_TEST_CASE(changing_all_wrong_nodes_cycles_for_murtys_matrix) {
  ContactMask in_contact = mask({true, true, false});
  for (int i = 0; i < 3; ++i) BOOST_TEST(change_all_that_is_wrong(murty, in_contact));

  BOOST_TEST((in_contact == mask({true, true, false})).all());
}

BOOST_AUTO_TEST_CASE(the_search_does_not_cycle) {
  // From each of the eight sets, including those of the cycle, to φ = 1/3 everywhere.
  for (int start = 0; start < 8; ++start) {
    ContactMask in_contact = mask({(start & 1) != 0, (start & 2) != 0, (start & 4) != 0});
    ContactSearch search;
    int revisions = 0;
    VectorXd phi;
    for (bool settled = false; !settled && revisions < 40; ++revisions) {
      phi = murty.phi(in_contact);
      settled = search.revise(in_contact, phi, murty.gap(phi), 1e-12);
    }
    BOOST_TEST_CONTEXT("start = " << start) {
      BOOST_TEST(revisions < 40);
      BOOST_TEST((phi.array() - 1. / 3).abs().maxCoeff() < 1e-15);
    }
  }
}

BOOST_AUTO_TEST_CASE(without_progress_it_ends_up_changing_only_the_last_wrong_node) {
  // The same two nodes are always wrong: at first both change, in the end only the last.
  ContactSearch search;
  ContactMask in_contact = mask({true, false, true, false});
  const auto revise = [&] {
    const ContactMask before = in_contact;
    VectorXd phi(4);
    VectorXd gap(4);
    for (const Index i : {0, 3}) phi[i] = gap[i] = 1;  // consistent in either state
    for (const Index i : {1, 2}) phi[i] = gap[i] = -1;
    BOOST_TEST(!search.revise(in_contact, phi, gap, 0));
    return (before != in_contact).eval();
  };

  int changing_both = 0;
  while (changing_both < 100 && (revise() == mask({false, true, true, false})).all()) {
    ++changing_both;
  }

  BOOST_TEST(changing_both == 11);  // the first revision and ten of patience
  for (int i = 0; i < 5; ++i) BOOST_TEST((revise() == mask({false, false, true, false})).all());
}

BOOST_AUTO_TEST_CASE(random_positive_definite_problems_are_solved_from_any_start) {
  for (int n = 1; n <= 12; ++n) {
    RandomInputs random(static_cast<std::uint64_t>(n));
    const MatrixXd root = MatrixXd::NullaryExpr(n, n, [&] { return random.uniform(-1, 1); });
    const MatrixXd matrix = root * root.transpose() + 0.02385 * MatrixXd::Identity(n, n);
    const Complementarity problem{matrix,
                                  VectorXd::NullaryExpr(n, [&] { return random.uniform(-1, 1); })};
    ContactMask in_contact = ContactMask::Constant(n, n % 2 == 0);
    ContactSearch search;
    VectorXd phi;
    int revisions = 0;
    for (bool settled = false; !settled && revisions < contact::max_revisions; ++revisions) {
      phi = problem.phi(in_contact);
      settled = search.revise(in_contact, phi, problem.gap(phi), 1e-12);
    }
    BOOST_TEST(revisions < contact::max_revisions);
    BOOST_TEST(phi.minCoeff() > -1e-14);
    BOOST_TEST(problem.gap(phi).minCoeff() > -1e-11);
    BOOST_TEST(std::abs(phi.dot(problem.gap(phi))) < 1e-11);
  }
}

BOOST_AUTO_TEST_SUITE_END()
