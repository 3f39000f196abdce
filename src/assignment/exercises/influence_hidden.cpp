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

Outcome influence_is_right(const Program& program, const Variant& variant) {
  const Cylinders c = cylinders_of(variant);
  Numbers k;
  for (int i = 0; i < 10; ++i) k.push_back(i);
  const Numbers found = ask(program, c.contact_modulus(), c.spacing, c.datum, k);
  Tally tally("the coefficients are right to nine digits");
  for (std::size_t i = 0; i < k.size(); ++i) {
    const double reference = reference_at(c.contact_modulus(), c.spacing, c.datum, k[i]);
    tally.part(near(found[i], reference, 1e-9 * std::abs(reference)), at("k", k[i]));
  }
  return tally.outcome();
}

Outcome influence_keeps_digits(const Program& program, const Variant& variant) {
  const Cylinders c = cylinders_of(variant);
  const Numbers k = {30, 300, 3e3, -3e4, 1e5};
  const double datum = 2 * c.spacing;  // near, so that its part of A_k does not hide the digits
  const Numbers found = ask(program, c.contact_modulus(), c.spacing, datum, k);
  Tally tally("the coefficients far away are right to nine digits");
  for (std::size_t i = 0; i < k.size(); ++i) {
    const double reference = reference_at(c.contact_modulus(), c.spacing, datum, k[i]);
    tally.part(near(found[i], reference, 1e-9 * std::abs(reference)), at("k", k[i]));
  }
  return tally.outcome();
}

}  // namespace

/// The checks that compare with this project's own functions. Their messages give none of the
/// expected numbers.
course::Checks hidden_checks() {
  return {{"influence-reference", influence_is_right}, {"influence-far", influence_keeps_digits}};
}

}  // namespace assignment::influence
