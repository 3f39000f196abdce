// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_contact/approach_control.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "line_contact/nested_grids.hpp"
#include "system/require.hpp"

namespace line_contact {
namespace {

// Finds the load P with δ(P) = approach by the secant rule for ln(δ − h_min) as a function of ln P.
class LoadSearch {
 public:
  LoadSearch(double approach, double least_gap, double first_guess)
      : target_(std::log(approach - least_gap)),
        least_gap_(least_gap),
        log_load_(std::log(first_guess)) {}

  double load() const { return std::exp(log_load_); }

  // Takes δ at load(), moves load() towards the root, and returns the relative change of
  // the load.
  double improve(double approach) {
    const double value = std::log(approach - least_gap_);
    if (has_previous_ && log_load_ != previous_log_load_ && value != previous_value_) {
      slope_ = (value - previous_value_) / (log_load_ - previous_log_load_);
    }
    previous_value_ = value;
    previous_log_load_ = log_load_;
    has_previous_ = true;
    const double change = (target_ - value) / slope_;
    log_load_ += change;
    return std::abs(change);
  }

 private:
  double target_, least_gap_, log_load_;
  bool has_previous_ = false;
  double previous_value_ = 0;
  double previous_log_load_ = 0;
  double slope_ = 1;  // d ln δ/d ln P at first: δ is P times a logarithm, which varies slowly
};

// The load is first searched for on a grid of at most this many nodes, where a solve takes a
// millisecond. Its discretisation, of second order in the spacing, leaves the load within 1e-8 of
// that on a finer grid if contact fills the grid, and within 3e-4 if it takes a thirtieth of it;
// converging beyond 1e-6 here would seldom save a solve on the fine grid.
constexpr Eigen::Index n_coarse_nodes = 512;
constexpr double settled_on_coarse = 1e-6;

// The secant rule needs about ten solves from the first guess; one that needs sixty will not
// converge.
constexpr int max_coarse_solves = 60;

// From there three or four solves reach rounding, since each error of the secant rule is of the
// order of the product of the previous two. What still moves the load after eight is the tolerance
// of the method itself.
constexpr double settled = 1e-12;
constexpr int max_fine_solves = 8;

Problem on_both_sides(Problem problem, Eigen::Index n_nodes) {
  const Grid& grid = problem.grid;
  problem.grid = grid_of_width(grid.end() - grid.begin(), n_nodes, grid.centre);
  return problem;
}

// Returns δ on a coarse grid. Contact may reach its ends, because the load is only a guess so far.
double coarse_approach(const Problem& problem, double line_load, double datum) {
  constexpr double tolerance = 1e-8;
  NestedSolution nested = solve_on_nested_grids(problem, line_load, tolerance);
  return to_solution(problem, line_load, element_loads(problem, std::move(nested))).approach(datum);
}

}  // namespace

Solution solve_for_approach(const Problem& problem, double approach, double datum,
                            const Method& method) {
  require_valid(problem);
  const double least_gap =
      problem.grid.nodes().unaryExpr([&](double x) { return problem.profile.gap(x); }).minCoeff();
  if (!(approach > least_gap && approach < largest_length)) {
    throw sys::InvalidQuantity(
        "approach", approach,
        fmt::format("greater than the least gap {}, or there is no contact, and less than {}",
                    least_gap, largest_length));
  }
  LoadSearch search(approach, least_gap,
                    std::numbers::pi / 8 * problem.contact_modulus * (approach - least_gap));
  const Problem coarse = on_both_sides(problem, std::min(problem.grid.n_nodes, n_coarse_nodes));
  for (int i = 0; i < max_coarse_solves; ++i) {
    if (search.improve(coarse_approach(coarse, search.load(), datum)) < settled_on_coarse) break;
  }

  Solution solution = method(problem, search.load());
  for (int i = 0; i < max_fine_solves && search.improve(solution.approach(datum)) > settled; ++i) {
    solution = method(problem, search.load());
  }
  return solution;
}

}  // namespace line_contact
