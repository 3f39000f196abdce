// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <cstddef>
#include <string>

#include "assignment/exercises/closed_form_checks.hpp"
#include "assignment/hidden/reference.hpp"

namespace assignment::closed_form {
namespace {

// Abscissas x/a under the load, beside it, and near the kinks 0 and ±1.
const Numbers near_the_load = {1e-3, 0.2, -0.5, 0.7071, -0.999, 1, 1.001, -1.5, 4, -15};

Outcome gradient_is_right(const Program& program, const std::string& id) {
  const Surface surface = surface_of(id);
  const Numbers x = times(surface.half_width, near_the_load);
  const Numbers reference = slopes_in_closed_form(surface, x);
  const Numbers found = ask(program, surface, x);
  Tally tally("the slope is right to 1e-9 of the greatest");
  for (std::size_t i = 0; i < x.size(); ++i) {
    tally.part(near(found[i], reference[i], 1e-9 * greatest(reference)),
               at("x/a", near_the_load[i]));
  }
  return tally.outcome();
}

Outcome gradient_keeps_digits(const Program& program, const std::string& id) {
  const Surface surface = surface_of(id);
  const Numbers xi = {1e2, -1e4, 1e6, -1e8};
  const Numbers x = times(surface.half_width, xi);
  const Numbers found = ask(program, surface, x);
  const Numbers reference = slopes_in_closed_form(surface, x);
  Tally tally("the slope is right to eight digits");
  for (std::size_t i = 0; i < x.size(); ++i) {
    tally.part(near(found[i], reference[i], 1e-8 * std::abs(reference[i])), at("x/a", xi[i]));
  }
  return tally.outcome();
}

}  // namespace

Checks hidden_checks() {
  return {{"gradient-reference", gradient_is_right},
          {"gradient-far-digits", gradient_keeps_digits}};
}

}  // namespace assignment::closed_form
