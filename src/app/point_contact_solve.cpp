// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include "app/point_contact_options.hpp"
#include "command_line/stage.hpp"
#include "point_contact/solver/methods.hpp"
#include "point_contact/solver/solution.hpp"

namespace app {
namespace {

point_contact::Solution frictionless(const PointContactInput& input) {
  if (input.method == "variational") {
    return point_contact::solve_by_variational_method(input.problem, input.load, input.tolerance);
  }
  return point_contact::solve_for_load(input.problem, input.load, input.tolerance);
}

}  // namespace

point_contact::Vector2 half_widths_of(const PointContactInput& input,
                                      const point_contact::Solution& solution) {
  return input.is_curved ? solution.semi_axes() : solution.area_semi_axes();
}

SolvedPointContact solve(const PointContactInput& input) {
  const Stopwatch stopwatch;
  SolvedPointContact solved{
      .solution = frictionless(input), .seconds = 0};
  solved.seconds = stopwatch.seconds();
  return solved;
}

std::vector<std::string> validity_warnings(const PointContactInput& input,
                                           const SolvedPointContact& solved) {
  const point_contact::Vector2 widths = half_widths_of(input, solved.solution);
  std::vector<std::string> warnings = half_space_warnings(widths[0], input.least_radius);
  const std::string coarse = contact::resolution_warning(solved.solution.resolution());
  if (!coarse.empty()) warnings.push_back(coarse);
  const double slope = solved.solution.approach / widths[1];
  if (slope > small_ratio) {
    warnings.push_back(fmt::format(
        "the approach is {:.2g} of the contact's half-width: small strains and slopes want less "
        "than {}",
        slope, small_ratio));
  }
  return warnings;
}

}  // namespace app
