// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "assignment/exercises/contact_solver.hpp"
#include "line_contact/cylinders.hpp"
#include "line_contact/dense_methods.hpp"

namespace assignment::contact_solver {
namespace {

// The variant's pair and three others like it, each on a grid that reaches beyond the contact.
std::vector<std::pair<std::string, Cylinders>> pairs_of(const Variant& variant) {
  const Cylinders own = cylinders_of(variant);
  Cylinders light = own;
  light.line_load *= 0.55;
  Cylinders swapped = own;
  std::swap(swapped.young1, swapped.young2);
  std::swap(swapped.poisson1, swapped.poisson2);
  swapped.line_load *= 0.8;
  Cylinders soft =
      own;  // modulus, load and curvature change together, so the half-width is the same
  soft.young2 *= 0.2;
  soft.poisson2 = 0.45;
  soft.radius1 *= 2.2;
  soft.radius2 *= 0.7;
  const double factor = soft.contact_modulus() * soft.relative_curvature() /
                        (own.contact_modulus() * own.relative_curvature());
  soft.line_load *= 0.9 * factor;
  return {{"your pair", own},
          {"your pair under a part of its load", light},
          {"your pair with its materials swapped", swapped},
          {"another pair", soft}};
}

struct Reference {
  double approach;
  double half_width;
  Numbers pressure;
};

Reference solve(const Cylinders& c) {
  using line_contact::Radius;
  const line_contact::CylinderPair pair(
      {c.young1, c.poisson1}, Radius::of_cylinder("radius1", c.radius1), {c.young2, c.poisson2},
      Radius::of_cylinder("radius2", c.radius2));
  const line_contact::Solution solution = line_contact::solve_by_matrix_inversion(
      {pair.profile(), pair.contact_modulus(), {c.n_nodes, c.spacing}}, c.line_load);
  return {solution.approach(c.datum), solution.half_width(),
          Numbers(solution.pressure.begin(), solution.pressure.end())};
}

using Comparison = std::function<bool(const Answer&, const Reference&)>;

Outcome compare(const Program& program, const Variant& variant, const std::string& property,
                const Comparison& is_right) {
  Tally tally(property);
  for (const auto& [name, cylinders] : pairs_of(variant)) {
    tally.part(is_right(ask(program, cylinders), solve(cylinders)), name);
  }
  return tally.outcome();
}

Outcome contact_is_right(const Program& program, const Variant& variant) {
  return compare(program, variant, "the pressure is right to 1e-6 of the greatest",
                 [](const Answer& found, const Reference& reference) {
                   const double tolerance = 1e-6 * greatest(reference.pressure);
                   bool all = true;
                   for (std::size_t i = 0; i < reference.pressure.size(); ++i) {
                     all = all && near(found.pressure[i], reference.pressure[i], tolerance);
                   }
                   return all;
                 });
}

Outcome contact_half_width_is_right(const Program& program, const Variant& variant) {
  return compare(program, variant, "half-width and approach are right to six digits",
                 [](const Answer& found, const Reference& reference) {
                   return near(found.half_width, reference.half_width,
                               1e-6 * reference.half_width) &&
                          near(found.approach, reference.approach, 1e-6 * reference.approach);
                 });
}

}  // namespace

/// The checks that compare with this project's own functions. Their messages give none of the
/// expected numbers.
course::Checks hidden_checks() {
  return {{"contact-reference", contact_is_right},
          {"contact-half-width", contact_half_width_is_right}};
}

}  // namespace assignment::contact_solver
