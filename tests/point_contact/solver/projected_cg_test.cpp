// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/solver/projected_cg.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

BOOST_AUTO_TEST_SUITE(projected_cg_test)

using Eigen::Index;
using Eigen::VectorXd;
using point_contact::ContactState;
using point_contact::Control;
using point_contact::Element;
using point_contact::ElementPotential;
using point_contact::Grid;
using point_contact::hexagonal_grid;
using point_contact::InfluenceOperator;
using point_contact::ProjectedCg;
using point_contact::RowTeam;

namespace {

const Grid grid = hexagonal_grid(1, 16);
const ElementPotential element(Element::pyramid, grid.lattice);
const RowTeam team(1);

// A disk of nodes in contact, half of them with a pressure of 1, on a paraboloid.
ContactState first_guess(InfluenceOperator& influence, double approach, const Grid& nodes = grid) {
  ContactState state;
  state.phi = VectorXd::Zero(nodes.size());
  state.in_contact.resize(nodes.size());
  VectorXd h(nodes.size());
  for (Index j = 0; j < nodes.n2; ++j) {
    for (Index i = 0; i < nodes.n1; ++i) {
      const Index k = nodes.index(i, j);
      const double r = nodes.node(i, j).norm();
      h[k] = r * r / 2;
      state.in_contact[k] = r < 0.3;
      state.phi[k] = state.in_contact[k] && i < nodes.n1 / 2 ? 1 : 0;
    }
  }
  influence.displacements(state.phi, state.gap);
  state.gap += h;
  state.gap.array() -= approach;
  state.approach = approach;
  return state;
}

// Steps until the error is 1e-13.
int solve(ProjectedCg& gradients, ContactState& state) {
  gradients.start(state);
  int steps = 0;
  for (; gradients.error() > 1e-13 && steps < 100; ++steps) gradients.step();
  return steps;
}

}  // namespace

BOOST_AUTO_TEST_CASE(gaps_in_contact_vanish_in_a_few_steps_under_a_given_approach) {
  InfluenceOperator influence(element, grid, team);
  ContactState state = first_guess(influence, 0.7);
  ProjectedCg gradients(influence, grid, team, Control::approach);

  BOOST_TEST(solve(gradients, state) < 30);
  BOOST_TEST(state.in_contact.select(state.gap, 0).cwiseAbs().maxCoeff() < 1e-12);
  BOOST_TEST(state.in_contact.select(0, state.phi).cwiseAbs().maxCoeff() == 0);
  BOOST_TEST(state.approach == 0.7);
}

BOOST_AUTO_TEST_CASE(the_total_is_kept_under_a_given_load_and_the_approach_follows) {
  InfluenceOperator influence(element, grid, team);
  ContactState state = first_guess(influence, 0);
  const double total = state.phi.sum();
  ProjectedCg gradients(influence, grid, team, Control::load);

  BOOST_TEST(solve(gradients, state) < 30);
  BOOST_TEST(std::abs(state.phi.sum() / total - 1) < 1e-12);
  BOOST_TEST(state.in_contact.select(state.gap, 0).cwiseAbs().maxCoeff() < 1e-12 * state.approach);
}

BOOST_AUTO_TEST_CASE(gaps_that_were_kept_up_are_those_computed_anew) {
  InfluenceOperator influence(element, grid, team);
  ContactState state = first_guess(influence, 0);
  ProjectedCg gradients(influence, grid, team, Control::load);
  solve(gradients, state);
  ContactState anew = first_guess(influence, state.approach);
  const VectorXd h_less_approach = [&] {
    VectorXd displacements;
    influence.displacements(anew.phi, displacements);
    return VectorXd(anew.gap - displacements);
  }();
  VectorXd displacements;
  influence.displacements(state.phi, displacements);

  BOOST_TEST((displacements + h_less_approach - state.gap).cwiseAbs().maxCoeff() <
             1e-13 * state.approach);
}

BOOST_AUTO_TEST_CASE(the_error_it_tells_is_about_the_error) {
  InfluenceOperator influence(element, grid, team);
  ContactState exact = first_guess(influence, 0.7);
  ProjectedCg to_the_end(influence, grid, team, Control::approach);
  solve(to_the_end, exact);
  ContactState state = first_guess(influence, 0.7);
  ProjectedCg gradients(influence, grid, team, Control::approach);
  gradients.start(state);
  for (int step = 0; step < 3; ++step) gradients.step();  // until φ has about its size
  for (int step = 0; step < 6; ++step) {
    const double error = (state.phi - exact.phi).cwiseAbs().maxCoeff() / exact.phi.maxCoeff();
    BOOST_TEST(gradients.error() > error / 2);
    BOOST_TEST(gradients.error() < error * 2);
    gradients.step();
  }
}

BOOST_AUTO_TEST_CASE(a_grid_sixteen_times_as_fine_takes_no_more_than_three_steps_more) {
  const auto steps_on = [](Index n, Control control) {
    const Grid nodes = hexagonal_grid(1, n);
    InfluenceOperator influence(ElementPotential(Element::pyramid, nodes.lattice), nodes, team);
    ContactState state = first_guess(influence, 0.7, nodes);
    ProjectedCg gradients(influence, nodes, team, control);
    gradients.start(state);
    int steps = 0;
    for (; gradients.error() > 1e-8 && steps < 100; ++steps) gradients.step();
    return steps;
  };
  for (const Control control : {Control::load, Control::approach}) {
    const int on_few = steps_on(32, control);
    const int on_many = steps_on(512, control);
    BOOST_TEST(on_many <= on_few + 3, on_many << " steps, " << on_few << " on few nodes");
  }
}

BOOST_AUTO_TEST_CASE(work_is_counted) {
  InfluenceOperator influence(element, grid, team);
  ContactState state = first_guess(influence, 0);
  ProjectedCg gradients(influence, grid, team, Control::load);
  gradients.start(state);
  gradients.step();
  gradients.step();

  BOOST_TEST(gradients.work().iterations == 2);
  BOOST_TEST(gradients.work().products == 2);
  BOOST_TEST(gradients.work().preconditionings == 4);  // two to start
}

BOOST_AUTO_TEST_SUITE_END()
