// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <cstdio>

#include "app/contact_options.hpp"
#include "command_line/options.hpp"
#include "command_line/stage.hpp"
#include "line_contact/dense_methods.hpp"
#include "line_contact/solver.hpp"

namespace app {
namespace {

line_contact::Solution frictionless(const ContactInput& input) {
  if (input.method == "variational") {
    return line_contact::solve_by_variational_method(input.problem, *input.line_load);
  }
  if (input.method == "matrix-inversion") {
    return line_contact::solve_by_matrix_inversion(input.problem, *input.line_load);
  }
  return line_contact::solve_by_fft(input.problem, *input.line_load, input.tolerance);
}

// The dense methods cannot report progress, so they announce a long solve in advance.
void announce_long_solve(const ContactInput& input) {
  constexpr Eigen::Index quick = 3000;
  const Eigen::Index n_nodes = input.problem.grid.n_nodes;
  if (input.method == "fft" || n_nodes <= quick || n_nodes > contact::max_dense_nodes) return;
  fmt::print(stderr, "halfspace: {} nodes by {}, whose cost grows with their cube; fft is quick\n",
             n_nodes, input.method);
}

}  // namespace

double half_width_of(const ContactInput& input, const line_contact::Solution& solution) {
  if (input.profile == "cylinder") return solution.half_width();
  const auto regions = solution.regions();
  if (regions.empty()) return 0;
  return (regions.back().end - regions.front().begin) / 2;
}

std::vector<std::string> validity_warnings(const ContactInput& input, const SolvedContact& solved) {
  auto warnings = half_space_warnings(half_width_of(input, solved.solution), input.least_radius);
  const std::string coarse = contact::resolution_warning(solved.solution.resolution());
  if (!coarse.empty()) warnings.push_back(coarse);
  return warnings;
}

SolvedContact solve(const ContactInput& input) {
  const Stopwatch stopwatch;
  announce_long_solve(input);
  SolvedContact solved{.solution = frictionless(input), .approach = {}, .seconds = 0};
  if (input.datum) solved.approach = solved.solution.approach(*input.datum);
  solved.seconds = stopwatch.seconds();
  return solved;
}

}  // namespace app
