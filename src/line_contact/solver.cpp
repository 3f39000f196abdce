// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_contact/solver.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "line_contact/nested_grids.hpp"
#include "system/require.hpp"

namespace line_contact {
namespace {

// Returns a one-sided problem completed by its mirror image.
Problem both_sides(Problem problem) {
  if (problem.grid.is_one_sided) {
    problem.grid = {2 * problem.grid.n_nodes - 1, problem.grid.spacing};
  }
  return problem;
}

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

// The message suggests a domain that is this many times as wide as the contact.
constexpr double suggested_margin = 1.1;

// The domain is doubled until the contact ends inside it. A contact that filled the previous domain
// reaches at least a quarter of the doubled width, 32 of these spacings, from the centre: its edge
// is known to one spacing, three per cent, which is within the margin. Only the edge is needed, so
// the pressure itself may be inaccurate.
constexpr Eigen::Index n_trial_nodes = 128;
constexpr double trial_tolerance = 1e-3;

// Enough doublings to exceed any meaningful length.
constexpr int max_doublings = 60;

// Returns the width of a domain about the same centre in which the contact has free ends, or
// nothing if the profile ends before.
std::optional<double> domain_needed(const Problem& problem, double line_load) {
  const double centre = problem.grid.centre;
  const double largest =
      2 * std::min(centre - problem.profile.begin(), problem.profile.end() - centre);
  double width = problem.grid.end() - problem.grid.begin();
  for (int doubling = 0; doubling < max_doublings && width < largest; ++doubling) {
    width = std::min(2 * width, largest);
    Problem wider = problem;
    wider.grid = grid_of_width(width, n_trial_nodes, centre);
    const NestedSolution found = solve_on_nested_grids(wider, line_load, trial_tolerance);
    const std::vector<Region> regions = regions_in_contact(wider.grid, found.phi);
    if (regions.empty()) return std::nullopt;
    const double reach =
        std::max(centre - regions.front().begin, regions.back().end - centre) / width;
    if (suggested_margin * reach < 0.5) return 2 * suggested_margin * reach * width;
  }
  return std::nullopt;
}

}  // namespace

double require_tolerance(double tolerance) {
  constexpr double too_large = 0.01;
  if (!(tolerance >= min_tolerance && tolerance < too_large)) {
    throw sys::InvalidQuantity(
        "tolerance", tolerance,
        fmt::format("from {}, which is rounding, to less than {}", min_tolerance, too_large));
  }
  return tolerance;
}

Solution solve_by_fft(const Problem& problem, double line_load, double tolerance,
                      const ProgressReport& report) {
  require_valid(problem);
  sys::require_positive("load", line_load);
  require_tolerance(tolerance);
  const Problem full = both_sides(problem);
  NestedSolution nested = solve_on_nested_grids(full, line_load, tolerance, report);
  require_free_ends(full, nested.phi, line_load);

  ElementLoads loads = element_loads(full, std::move(nested));
  if (problem.grid.is_one_sided) {
    loads.phi = loads.phi.tail(problem.grid.n_nodes).eval();
    loads.gap = loads.gap.tail(problem.grid.n_nodes).eval();
  }
  return to_solution(problem, line_load, std::move(loads));
}

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

void require_free_ends(const Problem& problem, const Eigen::VectorXd& pressure, double line_load) {
  const Grid& grid = problem.grid;
  const bool at_begin = !grid.is_one_sided && pressure[0] > 0;
  if (!at_begin && !(pressure[grid.n_nodes - 1] > 0)) return;

  Problem both_sides = problem;
  both_sides.grid.is_one_sided = false;
  if (grid.is_one_sided) both_sides.grid = grid_of_width(grid.end() - grid.begin(), grid.n_nodes);
  const std::optional<double> needed = domain_needed(both_sides, line_load);
  if (!needed) {
    throw sys::InvalidQuantity("domain", grid.end() - grid.begin(),
                               fmt::format("wider than the profile, which is given only from x = "
                                           "{} to {}: contact reaches its end",
                                           problem.profile.begin(), problem.profile.end()));
  }
  // The end nodes lie half a spacing inside the domain, and must be free.
  const auto n = static_cast<double>(grid.is_one_sided ? 2 * grid.n_nodes - 1 : grid.n_nodes);
  const double width = *needed * n / (n - 2);
  const double end = at_begin ? grid.begin() : grid.end();
  throw sys::InvalidQuantity(
      "domain", grid.end() - grid.begin(),
      fmt::format("at least {:.3g}, or contact reaches its end at x = {}", width, end));
}

}  // namespace line_contact
