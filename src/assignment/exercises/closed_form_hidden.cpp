// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <cstddef>
#include <string>

#include "assignment/exercises/closed_form_checks.hpp"
#include "assignment/hidden/reference.hpp"

namespace assignment::closed_form {
namespace {

// Compares the slopes at these x/a. The tolerance is a fraction of the greatest slope plus one of
// the slope there.
Outcome compare(const char* property, const Program& program, const std::string& id,
                const Numbers& xi, double of_greatest, double of_each) {
  const Surface surface = surface_of(id);
  const Numbers x = times(surface.half_width, xi);
  const Numbers found = ask(program, surface, x);
  const Numbers reference = slopes_in_closed_form(surface, x);
  Tally tally(property);
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double tolerance = of_greatest * greatest(reference) + of_each * std::abs(reference[i]);
    tally.part(near(found[i], reference[i], tolerance), at("x/a", xi[i]));
  }
  return tally.outcome();
}

// Under the load, beside it, and near the kinks 0 and ±1.
Outcome gradient_is_right(const Program& program, const std::string& id) {
  return compare("the slope is right to 1e-9 of the greatest", program, id,
                 {1e-3, 0.2, -0.5, 0.7071, -0.999, 1, 1.001, -1.5, 4, -15}, 1e-9, 0);
}

Outcome gradient_keeps_digits(const Program& program, const std::string& id) {
  return compare("the slope is right to eight digits", program, id, {1e2, -1e4, 1e6, -1e8}, 0,
                 1e-8);
}

}  // namespace

Checks hidden_checks() {
  return {{"gradient-reference", gradient_is_right},
          {"gradient-far-digits", gradient_keeps_digits}};
}

}  // namespace assignment::closed_form
