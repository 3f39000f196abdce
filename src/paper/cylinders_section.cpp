// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "line_contact/dense_methods.hpp"
#include "paper/bounds.hpp"
#include "paper/conventions.hpp"
#include "paper/convergence.hpp"
#include "paper/paper.hpp"
#include "paper/spheres.hpp"

namespace paper {
namespace {

using line_contact::Solution;

// The pressure over p₀ against x/a of Hertz, and how far it is from Hertz where either touches.
Figure pressure_figure(const Solution& solution, const Hertz& hertz) {
  std::vector<double> node_x, pressure, touching_x, difference;
  for (Eigen::Index i = 0; i < solution.grid.n_nodes; ++i) {
    const double x = solution.grid.x(i);
    node_x.push_back(x / hertz.half_width());
    pressure.push_back(solution.pressure[i] / hertz.peak_pressure());
    const double error = std::abs(pressure.back() - hertz.pressure(x) / hertz.peak_pressure());
    if (error == 0) continue;
    touching_x.push_back(node_x.back());
    difference.push_back(error);
  }
  std::vector<double> hertz_x, hertz_pressure;
  constexpr int n = 400;  // even in the angle, so that the steep ends have points enough
  for (int i = 0; i <= n; ++i) {
    const double xi = -std::cos(std::acos(-1.0) * i / n);
    hertz_x.push_back(xi);
    hertz_pressure.push_back(hertz.pressure(xi * hertz.half_width()) / hertz.peak_pressure());
  }
  return {.width_cm = 11.5,
          .height_cm = 5.8,
          .data = {{"nodes", {{"x", node_x}, {"pressure", pressure}}},
                   {"differences", {{"x", touching_x}, {"difference", difference}}},
                   {"hertz", {{"x", hertz_x}, {"pressure", hertz_pressure}}}}};
}

// What the elements make of something that Hertz has in closed form: wrong by the difference.
Estimate against(const ContactCase& c, double elements, double exact) {
  return {elements, std::abs(elements - exact) + rounded(c, exact)};
}

// The largest errors against Hertz on grids between whose nodes the edge of the contact lies at
// each hundredth of a spacing, from as many elements over the half-width as the case has.
struct EdgeSweep {
  double least_elements, most_elements;   // a/c
  Estimate peak, half_width;              // relative, magnitudes
  Estimate first_peak, first_half_width;  // those on the first grid, with a node at the edge
  double square;                          // (c/a)² on the coarsest of the grids
  int n_grids;
};

EdgeSweep sweep_edge(const ContactCase& c, const Hertz& hertz, double elements) {
  constexpr int n_grids = 100;  // peak and half-width err most at different places
  const double a = hertz.half_width();
  EdgeSweep sweep{elements, elements, {}, {}, {}, {}, 1 / (elements * elements), n_grids};
  for (int k = 0; k < n_grids; ++k) {
    const double here = elements + static_cast<double>(k) / n_grids;
    const line_contact::Grid grid{c.n_nodes + 2, a / here};
    const Solution solution = line_contact::solve_by_matrix_inversion(
        {c.cylinders.profile(), c.cylinders.contact_modulus(), grid}, c.line_load);
    sweep.most_elements = here;
    sweep.peak = max(sweep.peak, {std::abs(solution.peak_pressure() / hertz.peak_pressure() - 1),
                                  pressure_error(solution) + rounded(c, 1)});
    sweep.half_width = max(sweep.half_width, {std::abs(solution.half_width() / a - 1),
                                              half_width_error(solution) + rounded(c, 1)});
    if (k == 0) {
      sweep.first_peak = sweep.peak;
      sweep.first_half_width = sweep.half_width;
    }
  }
  return sweep;
}

void register_residuals(Document& document, const Solution& solution, const Hertz& hertz,
                        const ContactCase& c, const UnitSystem& units) {
  const contact::Residuals& r = solution.residuals;
  const double indentation = c.cylinders.profile().gap(solution.half_width());
  document.value("cylinders.residual.contact",
                 Value(r.gap, scientific(1).rounded_up(), units.length).as_is());
  document.value("cylinders.residual.separation",
                 Value(r.separation, scientific(1).rounded_up(), units.length).as_is());
  document.flag("cylinders.penetrates", r.separation > 0);
  document.value("cylinders.residual.load",
                 Value(r.load, scientific(1).rounded_up(), units.line_load).as_is());
  const double exact = c.cylinders.profile().gap(hertz.half_width());
  document.value("cylinders.indentation",
                 Value(against(c, indentation, exact), scientific(2), units.length));
  // That eq. (1a) holds in the contact is a claim.
  const Limit rounding(LimitKind::choice, 1e-11, "sums of hundreds of rounded terms");
  document.check(
      "contact-conditions",
      {Criterion::at_most("deepest penetration, over the gap at the edge",
                          Value(r.separation / indentation, scientific(1).rounded_up()).as_is(),
                          rounding),
       Criterion::at_most("residual of equilibrium, over the load",
                          Value(r.load / c.line_load, scientific(1).rounded_up()).as_is(),
                          rounding),
       Criterion::at_least(
           "least pressure, over the peak",
           Value(solution.pressure.minCoeff() / solution.peak_pressure(), scientific(1)).as_is(),
           {LimitKind::data, 0.0, "no tension"})},
      "eq. (1b) and equilibrium hold to rounding, and no pressure is a tension");
}

// The theory of half-spaces wants a contact that is small beside either body.
double smaller_radius(const ContactCase& c) {
  return 1 / std::max(std::abs(c.body1.radius.curvature()), std::abs(c.body2.radius.curvature()));
}

void claim_cylinders(Document& document, const ContactCase& c,
                     const std::optional<PrintedData>& printed_data, const Solution& solution,
                     const Hertz& hertz) {
  const Estimate half_width = against(c, solution.half_width(), hertz.half_width());
  if (printed_data) {
    document.claim("contact-is-small",
                   {.route = "the half-width of the elements' contact",
                    .expected = Verdict::confirmed,
                    .criteria = {Criterion::at_most(
                        "half-width over the smaller radius",
                        Value(1 / smaller_radius(c) * half_width, percent(1)),
                        {LimitKind::choice, 0.1,
                         "the half-space approximation requires it to be well below one"})}});
  }
  const double indentation = c.cylinders.profile().gap(solution.half_width());
  const double gap = solution.residuals.gap / indentation;
  // The residual is a sum of as many rounded terms as there are nodes.
  const double of_gap = rounded(static_cast<double>(solution.grid.n_nodes));
  document.check(
      "exact-at-matching-points",
      {Criterion::at_most("largest residual, over the gap at the edge before deformation",
                          Value(Estimate{gap, of_gap}, scientific(1).rounded_up()),
                          {LimitKind::choice, 1e-11, "sums of hundreds of rounded terms"})},
      "eq. (1a) holds at every node in contact to rounding error");
}

// Peak and half-width against Hertz wherever the edge lies, and those of spheres if the case has
// any.
void verify_by_hertz(Document& document, const ContactCase& c,
                     const std::optional<PointContactCase>& point_contact, const EdgeSweep& sweep) {
  const auto against_hertz = [](const std::string& what, double error, double square) {
    return Criterion::at_most(what, Value(error, scientific(2)).as_is(), of_second_order(square));
  };
  const auto at_worst = [&](const std::string& what, Estimate error) {
    return Criterion::at_most(what, Value(error, scientific(2).rounded_up()),
                              of_second_order(sweep.square));
  };
  std::vector<Criterion> criteria{at_worst("cylinders, peak: largest relative error", sweep.peak),
                                  at_worst("cylinders, half-width", sweep.half_width)};
  if (point_contact) {
    const SphereErrors spheres = errors_of(solve_spheres(c, *point_contact));
    criteria.push_back(against_hertz("spheres, peak", spheres.peak, spheres.square));
    criteria.push_back(against_hertz("spheres, radius", spheres.radius, spheres.square));
    criteria.push_back(against_hertz("spheres, approach", spheres.approach, spheres.square));
  }
  document.claim(
      "hertz-verifies",
      {.route = point_contact ? "overlapping triangles and pyramids against Hertz; for the "
                                "triangles with the edge at every hundredth of a spacing"
                              : "overlapping triangles against Hertz, with the edge of the "
                                "contact at every hundredth of a spacing",
       .expected = Verdict::confirmed,
       .criteria = criteria});
}

// Hertz's numbers, and how far the elements are from them on one grid and at most on many.
void tabulate_hertz(Document& document, const ContactCase& c, const UnitSystem& units,
                    const std::optional<PointContactCase>& point_contact, const Hertz& hertz,
                    const EdgeSweep& sweep) {
  literate::Table table("hertz",
                        {Column::text("contact"), Column::text("quantity"), Column::text("Hertz"),
                         Column("on this grid", scientific(2)).under("relative error"),
                         Column("maximum on all grids", scientific(2)).under("relative error")});
  const auto closed = [&](double number, int n_digits, const std::string& unit) {
    return Cell::latex(
        Value(number, significant(n_digits), unit).within(rounded(c, number)).latex());
  };
  const auto at_most = [](const Estimate& error) {
    return Cell::latex(Value(error, scientific(2).rounded_up()).latex());
  };
  const double a = hertz.half_width();
  table.add_row({"cylinders", "peak pressure", closed(hertz.peak_pressure(), 6, units.stress),
                 sweep.first_peak, at_most(sweep.peak)});
  table.add_row({"", "half-width", closed(a, 5, units.length), sweep.first_half_width,
                 at_most(sweep.half_width)});
  if (point_contact) {
    const Spheres solved = solve_spheres(c, *point_contact);
    const point_contact::Hertz& spheres = solved.hertz;
    const SphereErrors errors = errors_of(solved);
    const auto error = [](double number) { return Value(number, scientific(2)).as_is(); };
    table.add_row({"spheres", "peak pressure", closed(spheres.peak_pressure(), 4, units.stress),
                   Cell::latex(error(errors.peak).latex()), "–"});
    table.add_row({"", "radius", closed(spheres.radius(), 4, units.length),
                   Cell::latex(error(errors.radius).latex()), "–"});
    table.add_row({"", "approach", closed(spheres.approach(), 4, units.length),
                   Cell::latex(error(errors.approach).latex()), "–"});
    table.note("A dash: the spheres are solved on one lattice.");
  }
  document.table(std::move(table));
}

Value radius_of(const parameters::CylinderCase& body, const std::string& unit) {
  if (body.radius.is_plane()) return Value::text("∞");
  return Value(closed_form(1 / body.radius.curvature()), significant(4), unit);
}

void describe_bodies(Document& document, const ContactCase& c, const UnitSystem& units) {
  document.value("cylinders.radius1", radius_of(c.body1, units.length));
  document.value("cylinders.radius2", radius_of(c.body2, units.length));
  const bool hollow = c.body1.radius.curvature() < 0 || c.body2.radius.curvature() < 0;
  const bool plane = c.body1.radius.is_plane() || c.body2.radius.is_plane();
  document.flag("cylinders.hollow", hollow);
  document.flag("cylinders.plane", plane);
  document.flag("cylinders.pair", !hollow && !plane);
}

}  // namespace

void compute_cylinders(Document& document, const Case& from) {
  const ContactCase& c = from.contact;
  const UnitSystem& units = from.units;
  const Hertz hertz(c.cylinders, c.line_load);
  const Solution solution = invert_cylinders(c, hertz);

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
  document.value("cylinders.solves", Value(solution.work.revisions, integer()));
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
  const EdgeSweep sweep = sweep_edge(c, hertz, a / solution.grid.spacing);
  document.value("cylinders.peak-error", Value(sweep.peak, scientific(2).rounded_up()));
  document.value("cylinders.width-error", Value(sweep.half_width, scientific(2).rounded_up()));
  document.value("cylinders.sweep.grids", Value(sweep.n_grids, integer()));
  document.value("cylinders.sweep.least", Value(closed_form(sweep.least_elements), fixed(1)));
  document.value("cylinders.sweep.most", Value(closed_form(sweep.most_elements), fixed(1)));
  document.value("cylinders.approach",
                 Value(against(c, solution.approach(c.datum), hertz.approach(c.datum)),
                       significant(4), units.length));
  document.value("cylinders.datum", Value(c.datum, exact(), units.length));
  register_residuals(document, solution, hertz, c, units);

  claim_cylinders(document, c, from.printed_data, solution, hertz);
  verify_by_hertz(document, c, from.point_contact, sweep);
  tabulate_hertz(document, c, units, from.point_contact, hertz, sweep);
  document.figure("cylinder-pressure", pressure_figure(solution, hertz));
}

}  // namespace paper
