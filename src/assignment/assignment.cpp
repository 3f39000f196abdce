// SPDX-License-Identifier: GPL-3.0-or-later
#include "assignment/assignment.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "assignment/given/answers.hpp"
#include "assignment/given/bodies.hpp"
#include "exercise_list.hpp"

namespace assignment {
namespace {

// A half-space may stand for a cylinder if the contact is this small compared with the radii.
constexpr double most_of_radius = 0.1;

// Pressures beyond this fraction of E* would strain metals beyond the linear range.
constexpr double most_of_modulus = 0.02;

// Spacings over the half-width. There must be enough to show the shape, and the grid must end
// neither inside the contact nor far from it.
constexpr double fewest_spacings = 25;
constexpr double least_margin = 1.1;
constexpr double greatest_margin = 1.6;

bool is_plausible_material(double young, double poisson) {
  return young >= 1e9 && young <= 1e12 && poisson >= 0 && poisson <= 0.45;
}

bool is_valid_contact(const Cylinders& c) {
  const double modulus = c.contact_modulus();
  const double a =
      std::sqrt(4 * c.line_load / (std::numbers::pi * modulus * c.relative_curvature()));
  const double peak = 2 * c.line_load / (std::numbers::pi * a);
  const double edge = c.x(c.n_nodes - 1);
  return a <= most_of_radius * std::min(c.radius1, c.radius2) &&
         peak <= most_of_modulus * modulus && a >= fewest_spacings * c.spacing &&
         edge >= least_margin * a && edge <= greatest_margin * a && c.datum >= 10 * edge;
}

course::Checks all_of(std::span<const ChecksOfExercise> exercises) {
  course::Checks checks;
  for (const ChecksOfExercise of_exercise : exercises) checks.merge(guarded(of_exercise()));
  return checks;
}

}  // namespace

course::Checks public_checks() {
  return all_of(public_checks_of_exercises);
}

course::Checks hidden_checks() {
  return all_of(hidden_checks_of_exercises);
}

bool is_valid(const course::Variant& variant) {
  const Cylinders c = cylinders_of(variant);
  const Surface s = surface_of(variant);
  return is_plausible_material(c.young1, c.poisson1) &&
         is_plausible_material(c.young2, c.poisson2) && is_valid_contact(c) &&
         s.peak_pressure <= most_of_modulus * s.young && s.datum >= 10 * s.half_width;
}

}  // namespace assignment
