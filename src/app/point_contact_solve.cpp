// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <chrono>

#include "app/point_contact_output.hpp"
#include "app/validity.hpp"
#include "point_contact/solver/fft_solver.hpp"
#include "point_contact/solver/matrix_inversion.hpp"
#include "point_contact/solver/variational.hpp"

namespace app {
namespace {

point_contact::Solution frictionless(const PointContactInput& input) {
  if (input.approach) {
    return point_contact::solve_for_approach(input.problem, *input.approach, input.accuracy);
  }
  if (input.method == "variational") {
    return point_contact::solve_by_variational_method(input.problem, *input.load, input.accuracy);
  }
  if (input.method == "matrix-inversion") {
    return point_contact::solve_by_matrix_inversion(input.problem, *input.load);
  }
  return point_contact::solve_for_load(input.problem, *input.load, input.accuracy);
}

// Refuse a contact of a few nodes: these carry any load without a residual, and their pressure
// means nothing.
void require_resolved(const point_contact::Solution& solution) {
  constexpr Eigen::Index enough = 7;
  if (solution.n_in_contact() >= enough) return;
  throw sys::InputError(fmt::format(
      "nodes = {}: contact takes {} of them, which cannot resolve it: more nodes or a smaller "
      "domain",
      solution.grid.size(), solution.n_in_contact()));
}

}  // namespace

SolvedPointContact solve(const PointContactInput& input) {
  const auto start = std::chrono::steady_clock::now();
  SolvedPointContact solved{
      .solution = frictionless(input), .friction = {}, .tangential_displacement = {}, .seconds = 0};
  require_resolved(solved.solution);
  if (input.friction && input.tangential) {
    solved.friction = point_contact::partial_slip(input.problem, solved.solution, *input.friction,
                                                  *input.tangential, input.accuracy);
    if (input.is_of_revolution) {
      solved.tangential_displacement = point_contact::tangential_displacement(
          input.problem, solved.solution, *solved.friction, *input.friction,
          point_contact::tangential_compliance(input.material1, input.material2));
    }
  } else if (input.friction) {
    solved.friction = point_contact::sliding(solved.solution, *input.friction);
  }
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  solved.seconds = elapsed.count();
  solved.stresses = stresses_beneath(input, solved.solution);
  return solved;
}

std::vector<std::string> validity_warnings(const PointContactInput& input,
                                           const SolvedPointContact& solved) {
  const point_contact::Vector2 widths = half_widths_of(input, solved.solution);
  std::vector<std::string> warnings = half_space_warnings(widths[0], input.least_radius);
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
