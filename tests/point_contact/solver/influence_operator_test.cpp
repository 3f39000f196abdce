// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/solver/influence_operator.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <vector>

#include "random_inputs.hpp"

BOOST_AUTO_TEST_SUITE(influence_operator_test)

using Eigen::Index;
using Eigen::VectorXd;
using point_contact::Element;
using point_contact::ElementPotential;
using point_contact::Grid;
using point_contact::hexagonal_lattice;
using point_contact::InfluenceOperator;
using point_contact::Lattice;
using point_contact::RowTeam;
using point_contact::square_lattice;

namespace {

struct Case {
  Element element;
  Lattice lattice;
  bool is_staggered = false;

  Grid grid(Index n1, Index n2) const {
    return {.lattice = lattice, .n1 = n1, .n2 = n2, .is_staggered = is_staggered};
  }
};

std::vector<Case> cases() {
  Lattice flat = hexagonal_lattice(1);
  flat.second.y() *= 0.2;
  return {{Element::point, square_lattice(1)},     {Element::uniform, square_lattice(1)},
          {Element::bilinear, square_lattice(1)},  {Element::pyramid, hexagonal_lattice(1)},
          {Element::pyramid, square_lattice(0.3)}, {Element::pyramid, flat},
          {Element::bilinear, {{1, 0}, {0, 0.2}}}, {Element::pyramid, hexagonal_lattice(1), true},
          {Element::uniform, flat, true}};
}

VectorXd random_field(Index size, std::uint64_t seed = 7) {
  RandomInputs random(seed);
  return VectorXd::NullaryExpr(size, [&](Index) { return random.uniform(-1, 1); });
}

}  // namespace

BOOST_AUTO_TEST_CASE(displacements_are_the_sums_over_all_elements) {
  constexpr Index n1 = 11;
  constexpr Index n2 = 14;
  for (const Case& one : cases()) {
    const ElementPotential element(one.element, one.lattice);
    const RowTeam team(1);
    const Grid grid = one.grid(n1, n2);
    InfluenceOperator influence(element, grid, team);
    const VectorXd phi = random_field(n1 * n2);
    VectorXd result;
    influence.displacements(phi, result);

    double worst = 0;
    for (Index row = 0; row < n1 * n2; ++row) {
      double sum = 0;
      for (Index column = 0; column < n1 * n2; ++column) {
        const Index j = row / n1 - column / n1;
        const Index i = row % n1 - grid.neighbour(column % n1, column / n1, 0, j);
        sum += element(element.node(static_cast<double>(i), static_cast<double>(j))) * phi[column];
      }
      worst = std::max(worst, std::abs(sum - result[row]));
    }
    BOOST_TEST(worst < 1e-13, name_of(one.element) << ": " << worst);
  }
}

BOOST_AUTO_TEST_CASE(the_preconditioner_is_symmetric_and_positive) {
  constexpr Index n = 20;
  for (const Case& one : cases()) {
    const RowTeam team(1);
    InfluenceOperator influence(ElementPotential(one.element, one.lattice), one.grid(n, n), team);
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
      const VectorXd a = random_field(n * n, 2 * seed);
      const VectorXd b = random_field(n * n, 2 * seed + 1);
      VectorXd ma, mb;
      influence.precondition(a, ma);
      influence.precondition(b, mb);
      BOOST_TEST(std::abs(a.dot(mb) - b.dot(ma)) < 1e-12 * a.norm() * b.norm());
      BOOST_TEST(a.dot(ma) > 0);
    }
  }
}

BOOST_AUTO_TEST_CASE(the_preconditioner_undoes_the_product_away_from_the_ends) {
  constexpr Index n = 64;
  const RowTeam team(1);
  const Case pyramids{Element::pyramid, hexagonal_lattice(1)};
  InfluenceOperator influence(ElementPotential(pyramids.element, pyramids.lattice),
                              pyramids.grid(n, n), team);
  // a bump in the middle
  const VectorXd bump = VectorXd::NullaryExpr(n * n, [&](Index k) {
    const double x = static_cast<double>(k % n) - 31.5;
    const double y = static_cast<double>(k / n) - 31.5;
    return std::exp(-(x * x + y * y) / 50);
  });
  VectorXd displacements, undone;
  influence.displacements(bump, displacements);
  influence.precondition(displacements, undone);

  double worst = 0;
  for (Index j = n / 4; j < 3 * n / 4; ++j) {
    for (Index i = n / 4; i < 3 * n / 4; ++i) {
      worst = std::max(worst, std::abs(undone[j * n + i] - bump[j * n + i]));
    }
  }
  BOOST_TEST(worst < 0.1, worst);
}

BOOST_AUTO_TEST_CASE(the_result_may_stand_where_the_field_stood) {
  const RowTeam team(1);
  const Case cells{Element::uniform, square_lattice(1)};
  InfluenceOperator influence(ElementPotential(cells.element, cells.lattice), cells.grid(9, 9),
                              team);
  VectorXd field = random_field(81);
  VectorXd result;
  influence.displacements(field, result);
  influence.displacements(field, field);

  BOOST_TEST((field.array() == result.array()).all());
}

BOOST_AUTO_TEST_CASE(it_tells_the_memory_it_takes) {
  // two filters, eigenvalues and what they come from: about 8·1.5·2 + 16 + 16 bytes a node
  BOOST_TEST(InfluenceOperator::bytes(1024, 1024) == 56.0 * 1024 * 1024);
}

BOOST_AUTO_TEST_SUITE_END()
