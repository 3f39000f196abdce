// SPDX-License-Identifier: GPL-3.0-or-later
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "assignment/exercises/contact_solver_checks.hpp"
#include "assignment/hidden/reference.hpp"

namespace assignment::contact_solver {
namespace {

// The student's pair of cylinders and three variants, each with a grid that extends beyond the
// contact.
std::vector<std::pair<std::string, Cylinders>> pairs_of(const std::string& id) {
  const Cylinders pair = cylinders_of(id);
  Cylinders light = pair;
  light.line_load *= 0.55;
  Cylinders swapped = pair;
  std::swap(swapped.young1, swapped.young2);
  std::swap(swapped.poisson1, swapped.poisson2);
  swapped.line_load *= 0.8;
  // Modulus, load and curvature change together so that the half-width hardly changes.
  Cylinders soft = pair;
  soft.young2 *= 0.2;
  soft.poisson2 = 0.45;
  soft.radius1 *= 2.2;
  soft.radius2 *= 0.7;
  const double factor = soft.contact_modulus() * soft.relative_curvature() /
                        (pair.contact_modulus() * pair.relative_curvature());
  soft.line_load *= 0.9 * factor;
  return {{"a pair", pair},
          {"the same pair under a fraction of its load", light},
          {"the same pair with its materials swapped", swapped},
          {"a different pair", soft}};
}

using Comparison = std::function<bool(const Answer& found, const ContactOfCylinders& reference)>;

Outcome compare(const Program& program, const std::string& id, const std::string& property,
                const Comparison& is_right) {
  Tally tally(property);
  for (const auto& [name, cylinders] : pairs_of(id)) {
    tally.part(is_right(ask(program, cylinders), contact_of(cylinders)), name);
  }
  return tally.outcome();
}

Outcome contact_is_right(const Program& program, const std::string& id) {
  return compare(program, id, "the pressure is right to 1e-6 of the greatest",
                 [](const Answer& found, const ContactOfCylinders& reference) {
                   return same(found.pressure, reference.pressure, 1e-6);
                 });
}

Outcome contact_half_width_is_right(const Program& program, const std::string& id) {
  return compare(program, id, "half-width and approach are right to six digits",
                 [](const Answer& found, const ContactOfCylinders& reference) {
                   return near(found.half_width, reference.half_width,
                               1e-6 * reference.half_width) &&
                          near(found.approach, reference.approach, 1e-6 * reference.approach);
                 });
}

}  // namespace

Checks hidden_checks() {
  return {{"contact-reference", contact_is_right},
          {"contact-half-width", contact_half_width_is_right}};
}

}  // namespace assignment::contact_solver
