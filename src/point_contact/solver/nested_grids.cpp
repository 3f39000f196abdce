// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/solver/methods.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "contact/contact_search.hpp"
#include "point_contact/solver/problem.hpp"
#include "system/require.hpp"

namespace point_contact {
namespace {

using contact::ContactError;
using Eigen::Index;
using Eigen::VectorXd;

// One grid of the sequence: finds φ and the contact from a first guess of φ.
class LevelSolver {
 public:
  LevelSolver(const Problem& problem, Control control, double load_or_approach, const RowTeam& team)
      : control_(control),
        gaps_(initial_gaps(problem, team)),
        influence_(ElementPotential(problem.element, problem.grid.lattice), problem.grid, team),
        gradients_(influence_, problem.grid, team, control),
        total_(control == Control::load ? total_phi(problem, load_or_approach) : 0) {
    if (control == Control::approach) state_.approach = load_or_approach;
  }

  ElementLoads solve(VectorXd first_guess, double tolerance) {
    begin_with(std::move(first_guess));
    double previous = std::numeric_limits<double>::infinity();
    for (int without_gain = 0;;) {
      find_contact(tolerance);
      // The gaps were updated step by step; computing them anew drops the rounding that added up.
      update_gap();
      gradients_.start(state_);
      const double error = gradients_.error();
      if (error <= tolerance) return result();
      constexpr int patience = 3;
      if (!std::isfinite(error) || (error > previous / 2 && ++without_gain > patience)) {
        throw sys::InvalidQuantity(
            "tolerance", tolerance,
            fmt::format("at least {:.1e}, the rounding error of the pressure at {} nodes", error,
                        state_.phi.size()));
      }
      previous = error;
    }
  }

 private:
  void begin_with(VectorXd first_guess) {
    state_.phi = std::move(first_guess);
    state_.in_contact = (state_.phi.array() > 0) && (gaps_.array() < largest_length);
    if (!state_.in_contact.any()) touch_at_least_gap();
    keep_total();
    update_gap();
    // Nodes that penetrate at the first guess enter before anything is solved.
    state_.in_contact = state_.in_contact || state_.gap.array() < 0;
  }

  // A guess without contact starts from the node of the least gap, and under a given approach from
  // every node that would penetrate.
  void touch_at_least_gap() {
    Index least = 0;
    gaps_.minCoeff(&least);
    if (control_ == Control::approach) state_.in_contact = gaps_.array() < state_.approach;
    state_.in_contact[least] = true;
    const double something = control_ == Control::load ? 1 : state_.approach - gaps_[least];
    state_.phi = state_.in_contact.select(VectorXd::Constant(gaps_.size(), something), 0);
  }

  // No tension, and under a given load Σφ.
  void keep_total() {
    state_.phi = state_.in_contact.select(state_.phi.cwiseMax(0), 0);
    if (control_ == Control::load) state_.phi *= total_ / state_.phi.sum();
  }

  void update_gap() {
    influence_.displacements(state_.phi, state_.gap);
    state_.gap += gaps_;
    ++products_;
    if (control_ == Control::load) {
      const double n_in_contact = static_cast<double>(state_.in_contact.count());
      state_.approach = state_.in_contact.select(state_.gap, 0).sum() / n_in_contact;
    }
    state_.gap.array() -= state_.approach;
  }

  // begin excerpt: contact-of-points
  // Steps of the conjugate gradients and revisions of the contact take turns: reducing the error
  // to a fifth shows most of the nodes that are on the wrong side.
  void find_contact(double tolerance) {
    constexpr double enough_to_look = 0.2;
    constexpr int max_steps = 500;
    contact::ContactSearch search;
    for (int revision = 0; revision < contact::max_revisions; ++revision) {
      gradients_.start(state_);
      bool is_done = revision == 0 && gradients_.error() <= tolerance / 2;
      bool settled = !is_done || revise(search, tolerance);
      while (settled && !is_done) {
        // At least a step after a revision, before which nodes that have entered carry nothing
        const double error = gradients_.error();
        const double least = error > tolerance / 2 ? tolerance / 2 : 0;
        const double wanted = std::max(least, enough_to_look * error);
        for (int step = 0; step < max_steps && gradients_.error() > wanted; ++step) {
          gradients_.step();
        }
        settled = revise(search, tolerance);
        // If rounding stops the convergence, the caller checks the error that is left.
        is_done = wanted <= tolerance / 2 || !(gradients_.error() <= wanted);
      }
      if (settled) return;
    }
    throw ContactError(
        fmt::format("the contact did not settle in {} revisions", contact::max_revisions));
  }

  // Whether the contact may stay as it is. Nodes that enter carry nothing yet; where some leave,
  // the gap has to be computed anew.
  bool revise(contact::ContactSearch& search, double tolerance) {
    const double smallest_gap = tolerance * state_.phi.maxCoeff();
    if (search.revise(state_.in_contact, state_.phi, state_.gap, smallest_gap)) return true;
    ++revisions_;
    const bool some_leave =
        (!state_.in_contact && state_.phi.array() != 0).any() || (state_.phi.array() < 0).any();
    if (some_leave) {
      keep_total();
      update_gap();
    }
    return false;
  }
  // end excerpt: contact-of-points

  ElementLoads result() {
    contact::Work work = gradients_.work();
    work.revisions = revisions_;
    work.products += products_;
    return {std::move(state_.phi), std::move(state_.gap), state_.approach, gradients_.error(),
            work};
  }

  Control control_;
  VectorXd gaps_;  // h
  InfluenceOperator influence_;
  ProjectedCg gradients_;
  double total_;
  ContactState state_;
  int products_ = 0;
  int revisions_ = 0;
};

// The grids of the same domain with half the nodes each way, a quarter, down to a few; the coarsest
// first.
std::vector<Grid> nested_grids(const Grid& finest) {
  constexpr Index few = 32;
  std::vector<Grid> grids{finest};
  while (std::max(grids.back().n1, grids.back().n2) > few) {
    grids.push_back(finest.with_nodes(std::max<Index>(min_nodes, (grids.back().n1 + 1) / 2),
                                      std::max<Index>(min_nodes, (grids.back().n2 + 1) / 2)));
  }
  std::reverse(grids.begin(), grids.end());
  return grids;
}

// Whether the bodies touch at a node of this grid: a coarse one may miss a small body or contact.
bool can_touch(const Problem& problem, Control control, double load_or_approach) {
  const double limit = control == Control::approach ? load_or_approach : largest_length;
  const Grid& grid = problem.grid;
  for (Index j = 0; j < grid.n2; ++j) {
    for (Index i = 0; i < grid.n1; ++i) {
      if (problem.profile.gap(grid.node(i, j)) < limit) return true;
    }
  }
  return false;
}

}  // namespace

ElementLoads solve_on_nested_grids(const Problem& problem, Control control, double load_or_approach,
                                   const Accuracy& accuracy) {
  require_memory(problem.grid.n1, problem.grid.n2);
  const RowTeam team(accuracy.n_threads);
  ElementLoads loads;
  Grid coarser = problem.grid;
  Problem on_level = problem;
  for (const Grid& grid : nested_grids(problem.grid)) {
    const bool is_finest = grid.n1 == problem.grid.n1 && grid.n2 == problem.grid.n2;
    on_level.grid = grid;
    if (!is_finest && !can_touch(on_level, control, load_or_approach)) continue;

    VectorXd guess = VectorXd::Ones(grid.size());
    if (loads.phi.size() > 0) {
      // φ = c p/(πE*)
      guess = grid.spacing() / coarser.spacing() * prolongate(coarser, loads.phi, grid);
      loads = {};
    } else if (control == Control::approach) {
      guess.setZero();
    }
    constexpr double enough_to_start_from = 1e-5;
    const double tolerance =
        is_finest ? accuracy.tolerance : std::max(accuracy.tolerance, enough_to_start_from);
    loads =
        LevelSolver(on_level, control, load_or_approach, team).solve(std::move(guess), tolerance);
    coarser = grid;
  }
  return loads;
}

}  // namespace point_contact
