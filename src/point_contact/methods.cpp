// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/methods.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "contact/accuracy.hpp"
#include "contact/contact_search.hpp"
#include "contact/reference_methods.hpp"
#include "point_contact/influence_operator.hpp"
#include "point_contact/projected_cg.hpp"
#include "system/require.hpp"

namespace point_contact {
namespace {

using contact::ContactError;
using Eigen::Index;
using Eigen::VectorXd;
using Known = std::vector<bool>;

constexpr Index outside = -1;

// The index of node (i, j) if its value is known, else `outside`.
Index known_at(const Grid& grid, const Known& known, Index i, Index j) {
  if (i < 0 || i >= grid.n1 || j < 0 || j >= grid.n2) return outside;
  const Index index = grid.index(i, j);
  return known[size_of(index)] ? index : outside;
}

// Extrapolates values by one layer of nodes: each is the mean of the straight lines through two
// known nodes in a row, over the eight directions, and at most 0.
void continue_by_a_layer(const Grid& grid, VectorXd& values, Known& known) {
  constexpr std::array<std::pair<Index, Index>, 8> directions = {
      {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, -1}, {1, -1}, {-1, 1}}};
  const Known before = known;
  for (Index j = 0; j < grid.n2; ++j) {
    for (Index i = 0; i < grid.n1; ++i) {
      if (before[size_of(grid.index(i, j))]) continue;
      double sum = 0;
      int n = 0;
      for (const auto& [di, dj] : directions) {
        const Index near = known_at(grid, before, i + di, j + dj);
        if (near == outside) continue;
        const Index far = known_at(grid, before, i + 2 * di, j + 2 * dj);
        if (far == outside) continue;
        sum += 2 * values[near] - values[far];
        ++n;
      }
      if (n == 0) continue;
      values[grid.index(i, j)] = std::min(0.0, sum / n);
      known[size_of(grid.index(i, j))] = true;
    }
  }
}

// The position of a fine node between two coarse ones, along one side of the grids.
struct Position {
  Index lower;
  Index upper;
  double share;  // of the way to the upper one
};

Position position(Index fine_index, Index n_fine, Index n_coarse, double spacings) {
  const double from_middle = static_cast<double>(fine_index) - static_cast<double>(n_fine - 1) / 2;
  const double at = from_middle * spacings + static_cast<double>(n_coarse - 1) / 2;
  const double floor = std::floor(at);
  const auto lower = static_cast<Index>(floor);
  return {std::clamp<Index>(lower, 0, n_coarse - 1), std::clamp<Index>(lower + 1, 0, n_coarse - 1),
          at - floor};
}

}  // namespace

VectorXd prolongate(const Grid& coarse, const VectorXd& pressure, const Grid& fine) {
  // Extrapolate p² by the two layers that surround the fine nodes near the edge
  VectorXd squares = pressure.array().square();
  Known known(size_of(coarse.size()));
  for (Index i = 0; i < coarse.size(); ++i) known[size_of(i)] = pressure[i] > 0;
  const double far_outside = -squares.maxCoeff();
  continue_by_a_layer(coarse, squares, known);
  continue_by_a_layer(coarse, squares, known);
  for (Index i = 0; i < coarse.size(); ++i) {
    if (!known[size_of(i)]) squares[i] = far_outside;
  }

  const double spacings = fine.spacing / coarse.spacing;
  VectorXd result(fine.size());
  for (Index j = 0; j < fine.n2; ++j) {
    const Position y = position(j, fine.n2, coarse.n2, spacings);
    for (Index i = 0; i < fine.n1; ++i) {
      const Position x = position(i, fine.n1, coarse.n1, spacings);
      const auto along_x = [&](Index row) {
        return (1 - x.share) * squares[coarse.index(x.lower, row)] +
               x.share * squares[coarse.index(x.upper, row)];
      };
      const double square = (1 - y.share) * along_x(y.lower) + y.share * along_x(y.upper);
      result[fine.index(i, j)] = std::sqrt(std::max(0.0, square));
    }
  }
  return result;
}

namespace {

// Finds φ and the contact on one grid of the sequence from a first guess of φ.
class LevelSolver {
 public:
  LevelSolver(const Problem& problem, double load)
      : gaps_(initial_gaps(problem)),
        influence_(problem.element, problem.grid.n1, problem.grid.n2),
        gradients_(influence_),
        total_(total_phi(problem, load)) {}

  NodalLoads solve(VectorXd first_guess, double tolerance) {
    begin_with(std::move(first_guess));
    double previous = std::numeric_limits<double>::infinity();
    for (int without_gain = 0;;) {
      find_contact(tolerance);
      // The gaps were updated step by step; recomputing them removes the accumulated rounding.
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
    state_.in_contact = state_.phi.array() > 0;
    if (!state_.in_contact.any()) {
      // The contact fell between the nodes of the coarser grid
      Index least = 0;
      gaps_.minCoeff(&least);
      state_.in_contact[least] = true;
      state_.phi[least] = total_;
    }
    keep_total();
    update_gap();
    // Nodes that penetrate at the first guess enter the contact at once.
    state_.in_contact = state_.in_contact || state_.gap.array() < 0;
  }

  // Removes tension and restores Σφ.
  void keep_total() {
    state_.phi = state_.in_contact.select(state_.phi.cwiseMax(0), 0);
    state_.phi *= total_ / state_.phi.sum();
  }

  void update_gap() {
    influence_.displacements(state_.phi, state_.gap);
    state_.gap += gaps_;
    ++products_;
    const double n_in_contact = static_cast<double>(state_.in_contact.count());
    state_.approach = state_.in_contact.select(state_.gap, 0).sum() / n_in_contact;
    state_.gap.array() -= state_.approach;
  }

  // Alternates conjugate gradient steps with revisions of the contact: reducing the error to a
  // fifth reveals most of the nodes on the wrong side.
  void find_contact(double tolerance) {
    constexpr double enough_to_look = 0.2;
    constexpr int max_steps = 500;
    contact::ContactSearch search;
    for (int revision = 0; revision < contact::max_revisions; ++revision) {
      gradients_.start(state_);
      bool is_done = revision == 0 && gradients_.error() <= tolerance / 2;
      bool settled = !is_done || revise(search, tolerance);
      while (settled && !is_done) {
        // Take at least one step after a revision: until then, new nodes carry nothing
        const double error = gradients_.error();
        const double least = error > tolerance / 2 ? tolerance / 2 : 0;
        const double wanted = std::max(least, enough_to_look * error);
        for (int step = 0; step < max_steps && gradients_.error() > wanted; ++step) {
          gradients_.step();
        }
        settled = revise(search, tolerance);
        // If rounding stops the convergence, the caller checks the remaining error.
        is_done = wanted <= tolerance / 2 || !(gradients_.error() <= wanted);
      }
      if (settled) return;
    }
    throw ContactError(
        fmt::format("the contact did not settle in {} revisions", contact::max_revisions));
  }

  // Returns true if the contact needs no change. Nodes that enter carry nothing yet; when nodes
  // leave, the gap has to be recomputed.
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

  NodalLoads result() {
    contact::Work work = gradients_.work();
    work.revisions = revisions_;
    work.products += products_;
    return {std::move(state_.phi), std::move(state_.gap), state_.approach, gradients_.error(),
            work};
  }

  VectorXd gaps_;  // h
  InfluenceOperator influence_;
  ProjectedCg gradients_;
  double total_;
  ContactState state_;
  int products_ = 0;
  int revisions_ = 0;
};

// Grids of the same domain with the nodes per side halved repeatedly, the coarsest first. No node
// of a coarser grid lies outside those of a finer one.
std::vector<Grid> nested_grids(const Grid& finest) {
  constexpr Index few = 32;
  std::vector<Grid> grids{finest};
  while (std::max(grids.back().n1, grids.back().n2) > few &&
         std::min(grids.back().n1, grids.back().n2) >= 2 * min_nodes) {
    const Grid& finer = grids.back();
    grids.push_back({2 * finer.spacing, (finer.n1 + 1) / 2, (finer.n2 + 1) / 2});
  }
  std::reverse(grids.begin(), grids.end());
  return grids;
}

}  // namespace

NodalLoads solve_on_nested_grids(const Problem& problem, double load, double tolerance) {
  NodalLoads loads;
  Problem on_level = problem;
  for (const Grid& grid : nested_grids(problem.grid)) {
    VectorXd guess = VectorXd::Ones(grid.size());
    if (loads.phi.size() > 0) {
      // φ = c p/(πE*)
      const Grid& coarser = on_level.grid;
      guess = grid.spacing / coarser.spacing * prolongate(coarser, loads.phi, grid);
      loads = {};
    }
    on_level.grid = grid;
    constexpr double enough_to_start_from = 1e-5;
    const bool is_finest = grid.n1 == problem.grid.n1 && grid.n2 == problem.grid.n2;
    const double wanted = is_finest ? tolerance : std::max(tolerance, enough_to_start_from);
    loads = LevelSolver(on_level, load).solve(std::move(guess), wanted);
  }
  return loads;
}

Solution solve_for_load(const Problem& problem, double load, double tolerance) {
  contact::require_tolerance(tolerance, min_tolerance);
  return to_solution(problem, load, solve_on_nested_grids(problem, load, tolerance));
}

Solution solve_by_variational_method(const Problem& problem, double load, double tolerance) {
  constexpr int max_products = 20'000;
  contact::require_tolerance(tolerance, min_tolerance);
  const contact::Equations equations{initial_gaps(problem), total_phi(problem, load)};
  InfluenceOperator influence(problem.element, problem.grid.n1, problem.grid.n2);
  contact::ContactLoads loads = contact::minimise(
      equations, [&](const VectorXd& phi, VectorXd& u) { influence.displacements(phi, u); },
      tolerance, max_products);
  const double error = loads.misfit / loads.phi.maxCoeff();
  return to_solution(problem, load,
                     {std::move(loads.phi), std::move(loads.gap), loads.approach, error,
                      contact::Work{.iterations = loads.products / 2, .products = loads.products}});
}

}  // namespace point_contact
