// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <chrono>
#include <cstdio>

#include "app/contact_options.hpp"
#include "contact/approach_control.hpp"
#include "contact/fft_solver.hpp"
#include "contact/matrix_inversion.hpp"
#include "contact/variational.hpp"

namespace app {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// A line on standard error for every second that a solve takes.
contact::ProgressReport progress_line() {
  return [start = Clock::now(), shown = 0.0](const contact::Progress& progress) mutable {
    const double seconds = seconds_since(start);
    if (seconds < shown + 1) return;
    shown = seconds;
    fmt::print(stderr, "halfspace: {} nodes, contact revised {} times, {} iterations, {:.0f} s\n",
               progress.n_nodes, progress.revisions, progress.iterations, seconds);
  };
}

contact::Method method_of(const ContactInput& input) {
  if (input.method == "variational") return contact::solve_by_variational_method;
  if (input.method == "matrix-inversion") return contact::solve_by_matrix_inversion;
  return [tolerance = input.tolerance, report = progress_line()](const contact::Problem& problem,
                                                                 double line_load) {
    return contact::solve_by_fft(problem, line_load, tolerance, report);
  };
}

}  // namespace

SolvedContact solve(const ContactInput& input) {
  const Clock::time_point start = Clock::now();
  const contact::Method method = method_of(input);
  SolvedContact solved{input.line_load ? method(input.problem, *input.line_load)
                                       : contact::solve_for_approach(input.problem, *input.approach,
                                                                     *input.datum, method),
                       {},
                       {},
                       0};
  if (input.datum) solved.approach = solved.solution.approach(*input.datum);
  if (input.friction && input.tangential) {
    solved.friction = contact::partial_slip(input.problem, solved.solution, *input.friction,
                                            *input.tangential, method);
  } else if (input.friction) {
    solved.friction = contact::sliding(solved.solution, *input.friction);
  }
  solved.seconds = seconds_since(start);
  return solved;
}

}  // namespace app
