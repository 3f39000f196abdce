// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "contact/hertz.hpp"
#include "contact/matrix_inversion.hpp"
#include "literate/document/document.hpp"
#include "paper/bounds.hpp"
#include "paper/printed_data.hpp"
#include "parameters/case.hpp"

namespace paper {
namespace {

using contact::Hertz;
using contact::Solution;
using literate::Column;
using literate::Criterion;
using literate::exact;
using literate::fixed;
using literate::integer;
using literate::Limit;
using literate::LimitKind;
using literate::percent;
using literate::scientific;
using literate::significant;
using literate::Value;
using literate::Verdict;
using numerics::Estimate;

Solution solve(const parameters::ContactCase& c, const Hertz& hertz, long n_nodes) {
  return contact::solve_by_matrix_inversion({c.cylinders.profile(), c.cylinders.contact_modulus(),
                                             contact::grid_around(hertz.half_width(), n_nodes)},
                                            c.line_load);
}

// The pressure over p₀ against x/a of Hertz, and its difference from Hertz at the nodes.
literate::Figure pressure_figure(const Solution& solution, const Hertz& hertz) {
  std::vector<double> node_x, pressure, difference;
  for (Eigen::Index i = 0; i < solution.grid.n_nodes; ++i) {
    const double x = solution.grid.x(i);
    node_x.push_back(x / hertz.half_width());
    pressure.push_back(solution.pressure[i] / hertz.peak_pressure());
    difference.push_back((solution.pressure[i] - hertz.pressure(x)) / hertz.peak_pressure());
  }
  std::vector<double> hertz_x, hertz_pressure;
  constexpr int n = 400;  // even in the angle, so that the steep ends have points enough
  for (int i = 0; i <= n; ++i) {
    const double xi = -std::cos(std::acos(-1.0) * i / n);
    hertz_x.push_back(xi);
    hertz_pressure.push_back(hertz.pressure(xi * hertz.half_width()) / hertz.peak_pressure());
  }
  return {.width_cm = 12,
          .height_cm = 8.4,
          .data = {{"nodes", {{"x", node_x}, {"pressure", pressure}, {"difference", difference}}},
                   {"hertz", {{"x", hertz_x}, {"pressure", hertz_pressure}}}}};
}

literate::Table comparison_table(const parameters::ContactCase& c, const Solution& solution,
                                 const Hertz& hertz, const config::UnitSystem& units) {
  literate::Table table(
      "cylinders",
      {Column::text("quantity"), Column::text("unit"), Column("elements", scientific(8)),
       Column("Hertz", scientific(8)), Column("relative difference", scientific(2))});
  // What the elements give is meant as the solution of their equations; Hertz is another number.
  const auto add = [&](const char* name, const std::string& unit, double value, double error,
                       double exact) {
    const Estimate elements{value, error * value + rounded(c, value)};
    const Estimate closed{exact, rounded(c, exact)};
    table.add_row({name, unit, elements, closed, quotient(elements, closed) - Estimate{1, 0}});
  };
  add("half-width", units.length, solution.half_width(), half_width_error(solution),
      hertz.half_width());
  add("peak pressure", units.stress, solution.peak_pressure(), pressure_error(solution),
      hertz.peak_pressure());
  return table;
}

// What the elements make of something that Hertz has in closed form: wrong by the difference.
Estimate against(const parameters::ContactCase& c, double elements, double exact) {
  return {elements, std::abs(elements - exact) + rounded(c, exact)};
}

// The same contact on finer and finer grids.
literate::Table refinement_table(const parameters::ContactCase& c, const Hertz& hertz) {
  literate::Table table("cylinder-refinement",
                        {Column("nodes", integer()), Column("elements over $a$", fixed(1)),
                         Column("solves", integer()),
                         Column("peak pressure", scientific(2)).under("relative error of"),
                         Column("half-width, moment", scientific(2)).under("relative error of"),
                         Column("half-width, count", scientific(2)).under("relative error of")});
  for (const long n_nodes : {25L, 47L, 91L, 179L, 355L}) {
    const Solution solution = solve(c, hertz, n_nodes);
    const double a = hertz.half_width();
    const double rounding = rounded(c, 1);
    table.add_row({n_nodes, closed_form(a / solution.grid.spacing), solution.work.solves,
                   Estimate{solution.peak_pressure() / hertz.peak_pressure() - 1,
                            pressure_error(solution) + rounding},
                   Estimate{solution.half_width() / a - 1, half_width_error(solution) + rounding},
                   Estimate{solution.half_width_by_count() / a - 1, rounding}});
  }
  return table;
}

void register_residuals(literate::Document& document, const Solution& solution, const Hertz& hertz,
                        const parameters::ContactCase& c, const config::UnitSystem& units) {
  const contact::Residuals& r = solution.residuals;
  const double indentation = c.cylinders.profile().gap(solution.half_width());
  document.value("cylinders.residual.contact",
                 Value(r.gap, scientific(1).rounded_up(), units.length));
  document.value("cylinders.residual.separation",
                 Value(r.separation, scientific(1).rounded_up(), units.length));
  document.value("cylinders.residual.load",
                 Value(r.load, scientific(1).rounded_up(), units.line_load));
  const double exact = c.cylinders.profile().gap(hertz.half_width());
  document.value("cylinders.indentation",
                 Value(against(c, indentation, exact), scientific(2), units.length));
  // That eq. (1a) holds in the contact is a claim.
  const Limit rounding(LimitKind::rounding, 1e-11, "sums of hundreds of rounded terms");
  document.check(
      "contact-conditions",
      {Criterion::at_most("deepest penetration, over the gap at the edge",
                          Value(r.separation / indentation, scientific(1).rounded_up()).within(0),
                          rounding),
       Criterion::at_most("residual of equilibrium, over the load",
                          Value(r.load / c.line_load, scientific(1).rounded_up()).within(0),
                          rounding),
       Criterion::at_least(
           "least pressure, over the peak",
           Value(solution.pressure.minCoeff() / solution.peak_pressure(), scientific(1)).within(0),
           {LimitKind::stated, 0.0, "no tension"})},
      "eq. (1b) and equilibrium hold to rounding, and no pressure is a tension");
}

// The theory of half-spaces wants a contact that is small beside either body.
double smaller_radius(const parameters::ContactCase& c) {
  return 1 / std::max(std::abs(c.body1.radius.curvature()), std::abs(c.body2.radius.curvature()));
}

void claim_cylinders(literate::Document& document, const parameters::ContactCase& c,
                     const std::optional<PrintedData>& printed_data, const Solution& solution,
                     const Hertz& hertz) {
  const Estimate half_width = against(c, solution.half_width(), hertz.half_width());
  if (printed_data) {
    document.claim(
        "contact-is-small",
        {.route = "the half-width of the elements' contact",
         .expected = Verdict::confirmed,
         .criteria = {
             Criterion::at_least(
                 "half-width over the elements' width",
                 Value(1 / solution.grid.spacing * half_width, significant(3)),
                 {LimitKind::convention, 1.0, "less could not be told from a contact at a point"}),
             Criterion::at_most("half-width over the smaller radius",
                                Value(1 / smaller_radius(c) * half_width, percent(1)),
                                {LimitKind::convention, 0.1,
                                 "the theory of half-spaces wants it well below one"})}});
  }
  const double indentation = c.cylinders.profile().gap(solution.half_width());
  const double gap = solution.residuals.gap / indentation;
  // The residual is a sum of as many rounded terms as there are nodes.
  const double of_gap = rounded(static_cast<double>(solution.grid.n_nodes));
  document.claim("exact-at-matching-points",
                 {.route = "eq. (1a) with the displacements of the pressures found, at every node "
                           "in contact",
                  .expected = Verdict::confirmed,
                  .criteria = {Criterion::at_most(
                      "largest residual, over the gap at the edge before deformation",
                      Value(Estimate{gap, of_gap}, scientific(1).rounded_up()),
                      {LimitKind::rounding, 1e-11, "sums of hundreds of rounded terms"})}});
  const Limit of_second_order(LimitKind::convention,
                              std::pow(solution.grid.spacing / hertz.half_width(), 2),
                              "(c/a)²: linear elements have this order, and errors no larger");
  const auto against_hertz = [&](const char* what, double ratio, double error) {
    return Criterion::at_most(
        what, Value(Estimate{std::abs(ratio - 1), error + rounded(c, 1)}, scientific(2)),
        of_second_order);
  };
  document.claim(
      "hertz-verifies",
      {.route = "peak and half-width of overlapping triangles against Hertz",
       .expected = Verdict::confirmed,
       .criteria = {against_hertz("relative difference of the peaks",
                                  solution.peak_pressure() / hertz.peak_pressure(),
                                  pressure_error(solution)),
                    against_hertz("of the half-widths", solution.half_width() / hertz.half_width(),
                                  half_width_error(solution))}});
}

Value radius_of(const parameters::CylinderCase& body, const std::string& unit) {
  if (body.radius.is_plane()) return Value::text("∞");
  return Value(closed_form(1 / body.radius.curvature()), significant(4), unit);
}

void describe_bodies(literate::Document& document, const parameters::ContactCase& c,
                     const config::UnitSystem& units) {
  document.value("cylinders.radius1", radius_of(c.body1, units.length));
  document.value("cylinders.radius2", radius_of(c.body2, units.length));
  const bool hollow = c.body1.radius.curvature() < 0 || c.body2.radius.curvature() < 0;
  const bool plane = c.body1.radius.is_plane() || c.body2.radius.is_plane();
  document.flag("cylinders.hollow", hollow);
  document.flag("cylinders.plane", plane);
  document.flag("cylinders.pair", !hollow && !plane);
}

}  // namespace

void compute_cylinders(literate::Document& document, const parameters::ContactCase& c,
                       const config::UnitSystem& units,
                       const std::optional<PrintedData>& printed_data) {
  const Hertz hertz(c.cylinders, c.line_load);
  const Solution solution = solve(c, hertz, c.n_nodes);

  document.value("cylinders.load", Value(c.line_load, exact(), units.line_load));
  describe_bodies(document, c, units);
  const double radius = 1 / c.cylinders.relative_curvature();
  document.value("cylinders.relative-radius",
                 Value(radius, significant(4), units.length).within(rounded(c, radius)));
  const double modulus = c.cylinders.contact_modulus();
  document.value("cylinders.modulus",
                 Value(modulus, significant(4), units.stress).within(rounded(modulus)));
  document.value("cylinders.nodes", Value(c.n_nodes, integer()));
  document.value("cylinders.in-contact", Value(solution.n_in_contact(), integer()));
  document.value("cylinders.solves", Value(solution.work.solves, integer()));
  const double a = hertz.half_width();
  const double p0 = hertz.peak_pressure();
  // The grid is laid around a, so that their ratio does not depend on the curvature.
  document.value("cylinders.elements", Value(closed_form(a / solution.grid.spacing), fixed(1)));
  document.value("cylinders.hertz.half-width",
                 Value(a, significant(5), units.length).within(rounded(c, a)));
  document.value("cylinders.hertz.peak",
                 Value(p0, significant(6), units.stress).within(rounded(c, p0)));
  const double smaller = smaller_radius(c);
  document.value("cylinders.half-width-over-radius",
                 Value(a / smaller, percent(1)).within(rounded(c, a / smaller)));
  // The half-space theory wants a contact that is small beside the bodies (Johnson, ch. 4.1).
  constexpr double small = 0.1;
  document.flag("cylinders.small", a < small * smaller);
  const double peak_error = solution.peak_pressure() / hertz.peak_pressure() - 1;
  const double width_error = solution.half_width() / hertz.half_width() - 1;
  document.value("cylinders.peak-error",
                 Value(Estimate{std::abs(peak_error), pressure_error(solution) + rounded(c, 1)},
                       scientific(2)));
  document.value("cylinders.width-error",
                 Value(Estimate{std::abs(width_error), half_width_error(solution) + rounded(c, 1)},
                       scientific(2)));
  document.value("cylinders.approach",
                 Value(against(c, solution.approach(c.datum), hertz.approach(c.datum)),
                       significant(4), units.length));
  document.value("cylinders.datum", Value(c.datum, exact(), units.length));
  register_residuals(document, solution, hertz, c, units);

  claim_cylinders(document, c, printed_data, solution, hertz);
  document.table(comparison_table(c, solution, hertz, units));
  document.table(refinement_table(c, hertz));
  document.figure("cylinder-pressure", pressure_figure(solution, hertz));
}

}  // namespace paper
