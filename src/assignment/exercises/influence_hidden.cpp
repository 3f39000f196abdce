// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <cstddef>
#include <string>

#include "assignment/exercises/influence_checks.hpp"
#include "assignment/hidden/reference.hpp"

namespace assignment::influence {
namespace {

// Compares the coefficients at these k.
Outcome compare(const char* property, const Program& program, const Cylinders& c, double datum,
                const Numbers& k) {
  const double modulus = c.contact_modulus();
  const Numbers found = ask(program, modulus, c.spacing, datum, k);
  Tally tally(property);
  for (std::size_t i = 0; i < k.size(); ++i) {
    const double reference = influence_coefficient(modulus, c.spacing, datum, k[i]);
    tally.part(near(found[i], reference, 1e-9 * std::abs(reference)), at("k", k[i]));
  }
  return tally.outcome();
}

Outcome influence_is_right(const Program& program, const std::string& id) {
  const Cylinders c = cylinders_of(id);
  return compare("the coefficients are right to nine digits", program, c, c.datum,
                 {0, 1, 2, 3, 4, 5, 6, 7, 8, 9});
}

Outcome influence_keeps_digits(const Program& program, const std::string& id) {
  const Cylinders c = cylinders_of(id);
  const double datum = 2 * c.spacing;  // near, so that T(datum/c) does not hide errors of T(k)
  return compare("the coefficients far away are right to nine digits", program, c, datum,
                 {30, 300, 3e3, -3e4, 1e5});
}

}  // namespace

Checks hidden_checks() {
  return {{"influence-reference", influence_is_right}, {"influence-far", influence_keeps_digits}};
}

}  // namespace assignment::influence
