// SPDX-License-Identifier: GPL-3.0-or-later
#include "assignment/assignment.hpp"

#include <exception>

#include "assignment/exercises/closed_form.hpp"
#include "assignment/exercises/contact_solver.hpp"
#include "assignment/exercises/displacement.hpp"
#include "assignment/exercises/quadrature.hpp"
#include "system/error.hpp"

namespace assignment {
namespace {

using course::Curve;

// Abscissas from −3 to 3 half-widths of the load.
Numbers places() {
  Numbers xi;
  for (int i = -30; i <= 30; ++i) xi.push_back(0.1 * i);
  return xi;
}

Numbers slope_by_eq_3(const Program& program, const Surface& surface) {
  return closed_form::ask(program, surface, times(surface.half_width, places()));
}

Curve slope(const Program& program, const Variant& variant) {
  return {"Your slope by eq. (3)", "x/a", "slope", places(),
          slope_by_eq_3(program, surface_of(variant))};
}

Curve disagreement(const Program& program, const Variant& variant) {
  const Surface surface = surface_of(variant);
  const Numbers by_eq_3 = slope_by_eq_3(program, surface);
  Numbers difference = quadrature::ask(program, surface, times(surface.half_width, places())).value;
  for (std::size_t i = 0; i < difference.size(); ++i) difference[i] -= by_eq_3[i];
  return {"Your eq. (2) minus your eq. (3)", "x/a", "difference", places(), difference};
}

Curve depth(const Program& program, const Variant& variant) {
  const Surface surface = surface_of(variant);
  return {"Your displacement under the triangle", "x/a", "u_z in m", places(),
          displacement::ask(program, surface, times(surface.half_width, places()))};
}

Numbers nodes_of(const Cylinders& cylinders) {
  Numbers x;
  for (int i = 0; i < cylinders.n_nodes; ++i) x.push_back(cylinders.x(i));
  return x;
}

Curve contact_pressure(const Program& program, const Variant& variant) {
  const Cylinders cylinders = cylinders_of(variant);
  return {"Your contact pressure", "x in m", "p in Pa", nodes_of(cylinders),
          contact_solver::ask(program, cylinders).pressure};
}

Curve contact_gap(const Program& program, const Variant& variant) {
  const Cylinders cylinders = cylinders_of(variant);
  const contact_solver::Answer contact = contact_solver::ask(program, cylinders);
  return {"The gap that your pressure leaves, by your coefficients: eq. (1a), (1b)", "x in m",
          "gap in m", nodes_of(cylinders), contact_solver::gaps(program, cylinders, contact)};
}

}  // namespace

std::vector<Curve> curves(const Program& program, const Variant& variant) {
  std::vector<Curve> all;
  for (const auto curve : {slope, disagreement, depth, contact_pressure, contact_gap}) {
    try {
      all.push_back(curve(program, variant));
    } catch (const sys::ToolError&) {
      throw;
    } catch (const std::exception&) {
      // An exercise without an answer has no curve.
    }
  }
  return all;
}

}  // namespace assignment
