// SPDX-License-Identifier: GPL-3.0-or-later
#include "assignment/public_contact.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

#include "assignment/answers.hpp"

namespace assignment {
namespace {

using course::Numbers;
using course::Outcome;
using course::Program;
using course::Variant;

constexpr double pressure_roundings = 1e-8;

// The same cylinders with a part of the load, so that the contact still fits into the grid.
Cylinders with_load(Cylinders cylinders, double share) {
  cylinders.line_load *= share;
  return cylinders;
}

Outcome contact_carries_the_load(const Program& program, const Variant& variant) {
  Tally tally("spacing times the sum of the pressures is the load");
  for (const double share : {1., 0.6}) {
    const Cylinders c = with_load(cylinders_of(variant), share);
    const Numbers p = ask_contact(program, c).pressure;
    const double carried = c.spacing * std::accumulate(p.begin(), p.end(), 0.0);
    tally.part(near(carried, c.line_load, pressure_roundings * c.line_load),
               at("part of your load", share));
  }
  return tally.outcome();
}

Outcome contact_pressure_has_the_shape(const Program& program, const Variant& variant) {
  const Numbers p = ask_contact(program, cylinders_of(variant)).pressure;
  const double top = greatest(p);
  const std::size_t n = p.size();
  bool is_symmetric = top > 0;
  for (std::size_t i = 0; i < n; ++i) {
    is_symmetric = is_symmetric && near(p[i], p[n - 1 - i], pressure_roundings * top);
  }
  const auto least = std::min_element(p.begin(), p.end());

  Tally tally("the pressure");
  tally.part(top > 0 && *least >= 0, "is nowhere negative");
  tally.part(is_symmetric, "is symmetric");
  tally.part(top > 0 && near(p[n / 2], top, pressure_roundings * top), "is greatest in the middle");
  tally.part(top > 0 && p.front() == 0 && p.back() == 0, "is zero at the ends of the grid");
  return tally.outcome();
}

Outcome contact_closes_the_gap(const Program& program, const Variant& variant) {
  Tally tally("the gap u_z1 + u_z2 + h − δ");
  for (const double share : {1., 0.6}) {
    const Cylinders c = with_load(cylinders_of(variant), share);
    const ContactAnswer contact = ask_contact(program, c);
    const Numbers gap = gaps(program, c, contact);
    const double edge = c.x(c.n_nodes - 1);
    const double tolerance = 1e-6 * c.relative_curvature() * edge * edge / 2;
    bool is_closed = greatest(contact.pressure) > 0;
    bool is_open = is_closed;
    for (std::size_t i = 0; i < gap.size(); ++i) {
      if (contact.pressure[i] != 0) is_closed = is_closed && near(gap[i], 0, tolerance);
      if (contact.pressure[i] == 0) is_open = is_open && gap[i] >= -tolerance;
    }
    tally.part(is_closed, at("is zero where there is pressure, part of your load", share));
    tally.part(is_open, at("is not negative where there is none, part of your load", share));
  }
  return tally.outcome();
}

// Whether both lists agree to `tolerance` times the greatest number.
bool same(const Numbers& a, const Numbers& b, double tolerance) {
  bool all = true;
  for (std::size_t i = 0; i < a.size(); ++i) {
    all = all && near(a[i], b[i], tolerance * greatest(b));
  }
  return all;
}

Outcome contact_scales(const Program& program, const Variant& variant) {
  constexpr double tolerance = 100 * pressure_roundings;
  const Cylinders c = cylinders_of(variant);
  Cylinders large = with_load(c, 4);
  large.spacing *= 2;
  large.datum *= 2;
  Cylinders stiff = with_load(c, 3);
  stiff.young1 *= 3;
  stiff.young2 *= 3;
  const ContactAnswer one = ask_contact(program, c);
  const ContactAnswer two = ask_contact(program, large);
  const ContactAnswer three = ask_contact(program, stiff);
  const double a = one.half_width;

  Tally tally(
      "twice spacing and datum and four times the load (1), three times modulus and load (2)");
  tally.part(same(times(2, one.pressure), two.pressure, tolerance), "(1) double the pressure");
  tally.part(a > 0 && near(2 * a, two.half_width, tolerance * a), "(1) double the half-width");
  tally.part(same(times(3, one.pressure), three.pressure, tolerance), "(2) treble the pressure");
  tally.part(a > 0 && near(a, three.half_width, tolerance * a), "(2) leave the half-width alone");
  return tally.outcome();
}

// The half-width found with `spacings` and three eighths of a spacing over the half-width a. The
// fraction is always the same, because the error depends on where the contact ends between nodes.
double half_width_on(const Program& program, Cylinders c, double a, int spacings) {
  c.spacing = a / (spacings + 0.375);
  c.n_nodes = 2 * static_cast<int>(1.3 * spacings) + 1;
  return ask_contact(program, c).half_width;
}

Outcome contact_half_width_converges(const Program& program, const Variant& variant) {
  const Cylinders c = cylinders_of(variant);
  const double a = ask_contact(program, c).half_width;
  Tally tally("each halving of the spacing changes the half-width by a quarter of the last change");
  for (const int spacings : {8, 12}) {
    const double coarse = half_width_on(program, c, a, spacings);
    const double middle = half_width_on(program, c, a, 2 * spacings);
    const double fine = half_width_on(program, c, a, 4 * spacings);
    const double ratio = (coarse - middle) / (middle - fine);
    tally.part(ratio > 3 && ratio < 5, at("spacings over the half-width at first", spacings));
  }
  return tally.outcome();
}

}  // namespace

Numbers gaps(const Program& program, const Cylinders& c, const ContactAnswer& contact) {
  Numbers k(static_cast<std::size_t>(c.n_nodes));
  std::iota(k.begin(), k.end(), 0);
  const Numbers influence = ask_influence(program, c.contact_modulus(), c.spacing, c.datum, k);
  Numbers gap;
  for (int i = 0; i < c.n_nodes; ++i) {
    double sum = c.relative_curvature() * c.x(i) * c.x(i) / 2 - contact.approach;
    for (int j = 0; j < c.n_nodes; ++j) {
      sum += influence[static_cast<std::size_t>(std::abs(i - j))] *
             contact.pressure[static_cast<std::size_t>(j)];
    }
    gap.push_back(sum);
  }
  return gap;
}

course::Checks public_contact_checks() {
  return {{"contact-load", contact_carries_the_load},
          {"contact-pressure", contact_pressure_has_the_shape},
          {"contact-gap", contact_closes_the_gap},
          {"contact-scaling", contact_scales},
          {"contact-convergence", contact_half_width_converges}};
}

}  // namespace assignment
