// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "app/point_contact_options.hpp"
#include "command_line/stage.hpp"
#include "point_contact/closed_forms/spheres.hpp"
#include "point_contact/solver/methods.hpp"
#include "point_contact/solver/solution.hpp"

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

// The stresses at the depths that the input asks for, in the body that it names.
std::vector<StressBeneath> stresses_beneath(const PointContactInput& input,
                                            const point_contact::Solution& solution) {
  const elasticity::Material& material = input.is_second_body ? input.material2 : input.material1;
  std::vector<StressBeneath> stresses;
  for (const double z : input.depths) {
    const Eigen::Matrix3d s = point_contact::field_beneath(solution, material, {0, 0, z}).stress;
    const Eigen::Vector3d principal =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(s, Eigen::EigenvaluesOnly).eigenvalues();
    const Eigen::Vector3d differences(principal[1] - principal[0], principal[2] - principal[1],
                                      principal[2] - principal[0]);
    StressBeneath at{.z = z,
                     .stress = s,
                     .max_shear = differences[2] / 2,
                     .von_mises = std::sqrt(differences.squaredNorm() / 2),
                     .huber_max_shear = {}};
    if (input.hertz) {
      // on the axis rr = tt, and the principal stresses are these and zz
      const auto huber = point_contact::Huber(*input.hertz, material.poisson()).stress(0, z);
      at.huber_max_shear = std::abs(huber.rr - huber.zz) / 2;
    }
    stresses.push_back(at);
  }
  return stresses;
}

}  // namespace

point_contact::Vector2 half_widths_of(const PointContactInput& input,
                                      const point_contact::Solution& solution) {
  return input.curvatures ? solution.semi_axes() : solution.area_semi_axes();
}

SolvedPointContact solve(const PointContactInput& input) {
  const Stopwatch stopwatch;
  SolvedPointContact solved{
      .solution = frictionless(input), .seconds = 0};
  require_resolved(solved.solution);
  solved.seconds = stopwatch.seconds();
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
