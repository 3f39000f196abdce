// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <cstddef>
#include <numbers>

#include "assignment/exercises/influence.hpp"
#include "line_contact/element.hpp"

namespace assignment::influence {
namespace {

using line_contact::Element;

// The reference for A_k.
double reference_at(double contact_modulus, double spacing, double datum, double k) {
  const double rise = line_contact::influence_coefficient(Element::triangular, k) -
                      line_contact::influence_coefficient(Element::triangular, datum / spacing);
  return -2 * spacing / (std::numbers::pi * contact_modulus) * rise;
}

// Compares the coefficients at these k.
Outcome compare(const char* property, const Program& program, const Cylinders& c, double datum,
                const Numbers& k) {
  const Numbers found = ask(program, c.contact_modulus(), c.spacing, datum, k);
  Tally tally(property);
  for (std::size_t i = 0; i < k.size(); ++i) {
    const double reference = reference_at(c.contact_modulus(), c.spacing, datum, k[i]);
    tally.part(near(found[i], reference, 1e-9 * std::abs(reference)), at("k", k[i]));
  }
  return tally.outcome();
}

Outcome influence_is_right(const Program& program, const Variant& variant) {
  const Cylinders c = cylinders_of(variant);
  return compare("the coefficients are right to nine digits", program, c, c.datum,
                 {0, 1, 2, 3, 4, 5, 6, 7, 8, 9});
}

Outcome influence_keeps_digits(const Program& program, const Variant& variant) {
  const Cylinders c = cylinders_of(variant);
  const double datum = 2 * c.spacing;  // near, so that its part of A_k does not hide the digits
  return compare("the coefficients far away are right to nine digits", program, c, datum,
                 {30, 300, 3e3, -3e4, 1e5});
}

}  // namespace

/// The checks that compare with this project's own functions. Their messages give none of the
/// expected numbers.
course::Checks hidden_checks() {
  return {{"influence-reference", influence_is_right}, {"influence-far", influence_keeps_digits}};
}

}  // namespace assignment::influence
