// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

#include "app/contact_options.hpp"
#include "command_line/options.hpp"
#include "command_line/stage.hpp"
#include "line_contact/dense_methods.hpp"
#include "line_contact/solver.hpp"

namespace app {
namespace {

// Prints a line on standard error for every second that a solve takes, if somebody sees it on a
// terminal: what is written to a file does not depend on the speed of the machine.
line_contact::ProgressReport progress_line() {
  if (::isatty(STDERR_FILENO) == 0) return {};
  return [stopwatch = Stopwatch(), shown = 0.0](const line_contact::Progress& progress) mutable {
    const double seconds = stopwatch.seconds();
    if (seconds < shown + 1) return;
    shown = seconds;
    fmt::print(stderr,
               "halfspace: {} nodes, revisions of the contact: {}, iterations: {}, {:.0f} s\n",
               progress.n_nodes, progress.revisions, progress.iterations, seconds);
  };
}

line_contact::Method method_of(const ContactInput& input) {
  if (input.method == "variational") return line_contact::solve_by_variational_method;
  if (input.method == "matrix-inversion") return line_contact::solve_by_matrix_inversion;
  return [tolerance = input.tolerance, report = progress_line()](
             const line_contact::Problem& problem, double line_load) {
    return line_contact::solve_by_fft(problem, line_load, tolerance, report);
  };
}

// The dense methods cannot report progress, so they announce a long solve in advance.
void announce_long_solve(const ContactInput& input) {
  constexpr Eigen::Index quick = 3000;
  const Eigen::Index n_nodes = input.problem.grid.n_nodes;
  if (input.method == "fft" || n_nodes <= quick || n_nodes > line_contact::max_dense_nodes) return;
  fmt::print(stderr, "halfspace: {} nodes by {}, whose cost grows with their cube; fft is quick\n",
             n_nodes, input.method);
}

// Refuse a contact of one or two nodes: these carry any load without a residual, and their
// pressure means nothing.
void require_resolved(const line_contact::Solution& solution) {
  constexpr Eigen::Index enough = 3;
  Eigen::Index most = 0;
  for (const line_contact::Region& region : solution.regions()) {
    const bool is_mirrored = solution.grid.is_one_sided && region.begin < 0;
    most = std::max(most, is_mirrored ? 2 * region.n_nodes - 1 : region.n_nodes);
  }
  if (most >= enough) return;
  throw sys::InputError(fmt::format(
      "nodes = {}: contact takes {} of them, which cannot resolve it: more nodes or a narrower "
      "domain",
      solution.grid.n_nodes, solution.n_in_contact()));
}

}  // namespace

double half_width_of(const ContactInput& input, const line_contact::Solution& solution) {
  if (input.profile == "cylinder") return solution.half_width();
  const auto regions = solution.regions();
  if (regions.empty()) return 0;
  return (regions.back().end - regions.front().begin) / 2;
}

std::vector<std::string> validity_warnings(const ContactInput& input, const SolvedContact& solved) {
  return half_space_warnings(half_width_of(input, solved.solution), input.least_radius);
}

SolvedContact solve(const ContactInput& input) {
  const Stopwatch stopwatch;
  const line_contact::Method method = method_of(input);
  announce_long_solve(input);
  SolvedContact solved{.solution = input.line_load
                                       ? method(input.problem, *input.line_load)
                                       : line_contact::solve_for_approach(
                                             input.problem, *input.approach, *input.datum, method),
                       .approach = {},
                       .seconds = 0};
  require_resolved(solved.solution);
  if (input.datum) solved.approach = solved.solution.approach(*input.datum);
  solved.seconds = stopwatch.seconds();
  return solved;
}

}  // namespace app
