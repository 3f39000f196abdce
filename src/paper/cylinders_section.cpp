// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "elasticity/material.hpp"
#include "line_contact/methods.hpp"
#include "paper/conventions.hpp"
#include "paper/paper.hpp"

namespace paper {
namespace {

using line_contact::Problem;
using line_contact::Solution;

Problem problem_on(const ContactCase& c, const line_contact::Grid& grid) {
  return {c.cylinders.profile(), c.cylinders.contact_modulus(), grid};
}

// p/p₀ over x/a of Hertz, and the difference from Hertz where either pressure is positive.
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
  constexpr int n = 400;  // evenly spaced in the angle, so that the steep ends have enough points
  for (int i = 0; i <= n; ++i) {
    const double xi = -std::cos(std::numbers::pi * i / n);
    hertz_x.push_back(xi);
    hertz_pressure.push_back(hertz.pressure(xi * hertz.half_width()) / hertz.peak_pressure());
  }
  return {.width_cm = 11.5,
          .height_cm = 4.6,
          .data = {{"nodes", {{"x", node_x}, {"pressure", pressure}}},
                   {"differences", {{"x", touching_x}, {"difference", difference}}},
                   {"hertz", {{"x", hertz_x}, {"pressure", hertz_pressure}}}}};
}

// The relative errors against Hertz on the case's grid, and the largest on grids that place the
// edge of the contact at every hundredth of a spacing.
struct HertzErrors {
  double peak = 0, half_width = 0;
};
struct EdgeSweep {
  HertzErrors first, largest;
  double square;  // (c/a)² on the coarsest of the grids
};
constexpr int n_grids = 100;

EdgeSweep sweep_edge(const ContactCase& c, const Hertz& hertz, double elements) {
  EdgeSweep sweep{{}, {}, 1 / (elements * elements)};
  for (int k = 0; k < n_grids; ++k) {
    const double spacing = hertz.half_width() / (elements + static_cast<double>(k) / n_grids);
    const Solution solution = line_contact::solve_by_fft(
        problem_on(c, {.n_nodes = c.n_nodes + 2, .spacing = spacing}), c.line_load, 1e-10);
    const HertzErrors errors{std::abs(solution.peak_pressure() / hertz.peak_pressure() - 1),
                             std::abs(solution.half_width() / hertz.half_width() - 1)};
    if (k == 0) sweep.first = errors;
    sweep.largest.peak = std::max(sweep.largest.peak, errors.peak);
    sweep.largest.half_width = std::max(sweep.largest.half_width, errors.half_width);
  }
  return sweep;
}

Value rounded_up(double error) {
  return Value(error, scientific(2).rounded_up()).as_is();
}

// Compares peak and half-width with Hertz wherever the edge lies, and those of spheres if the case
// has any.
void compare_with_hertz(Document& document, const Case& from, const Hertz& hertz,
                        const EdgeSweep& sweep) {
  const UnitSystem& units = from.units;
  literate::Table table("hertz",
                        {Column::text("contact"), Column::text("quantity"), Column::text("Hertz"),
                         Column::text("on this grid"), Column::text("largest on all grids")});
  std::vector<Criterion> criteria;
  const auto add = [&](const char* contact, const char* quantity, const Value& closed,
                       double on_grid, const Value* on_all, double square) {
    table.add_row({contact, quantity, Cell::latex(closed.latex()),
                   Cell::latex(Value(on_grid, scientific(2)).as_is().latex()),
                   on_all ? Cell::latex(on_all->latex()) : Cell("–")});
    criteria.push_back(Criterion::at_most(
        std::string(quantity) + (on_all ? " of cylinders" : " of spheres"),
        on_all ? *on_all : Value(on_grid, scientific(2)).as_is(),
        Limit(square, LimitKind::choice,
              "$(c/a)^2$; the error of linear interpolation at the peak is an eighth of it")));
  };
  const auto closed = [](double number, int n_digits, const std::string& unit) {
    return Value(number, significant(n_digits), unit).as_is();
  };
  const Value peak = rounded_up(sweep.largest.peak);
  const Value half_width = rounded_up(sweep.largest.half_width);
  add("cylinders", "peak pressure", closed(hertz.peak_pressure(), 6, units.stress),
      sweep.first.peak, &peak, sweep.square);
  add("", "half-width", closed(hertz.half_width(), 5, units.length), sweep.first.half_width,
      &half_width, sweep.square);
  if (from.point_contact) {
    const Spheres spheres = solve_spheres(from.contact, *from.point_contact);
    const SphereErrors errors = errors_of(spheres);
    add("spheres", "peak pressure", closed(spheres.hertz.peak_pressure(), 4, units.stress),
        errors.peak, nullptr, errors.square);
    add("", "radius", closed(spheres.hertz.radius(), 4, units.length), errors.radius, nullptr,
        errors.square);
    add("", "approach", closed(spheres.hertz.approach(), 4, units.length), errors.approach, nullptr,
        errors.square);
  }
  document.table(std::move(table));
  document.value("cylinders.peak-error", peak);
  document.value("cylinders.width-error", half_width);
  document.claim(
      "hertz-verifies",
      {.route =
           "relative errors against Hertz; for cylinders the largest over all positions of the "
           "contact's edge between two nodes",
       .expected = Verdict::holds,
       .criteria = std::move(criteria)});
}

// Solves the same discrete contact by three methods.
void compare_methods(Document& document, const ContactCase& c, const Hertz& hertz,
                     const Problem& problem, const Solution& inversion) {
  double difference = 0;
  for (const Solution& other : {line_contact::solve_by_variational_method(problem, c.line_load),
                                line_contact::solve_by_fft(problem, c.line_load, 1e-12)}) {
    difference =
        std::max(difference, (other.pressure - inversion.pressure).lpNorm<Eigen::Infinity>());
  }
  const Value share = Value(difference / hertz.peak_pressure(), scientific(1).rounded_up()).as_is();
  document.value("methods.pressure", share);
  document.check(
      "three-methods-agree",
      {Criterion::at_most("largest difference of the pressures over the peak", share,
                          Limit(1e-8, LimitKind::choice, "the tolerance of the iterations"))},
      "three methods solve one discrete problem");
}

// Checks eq. (1a) in contact, eq. (1b) outside, and equilibrium.
void check_conditions(Document& document, const ContactCase& c, const Solution& solution,
                      const UnitSystem& units) {
  const contact::Residuals& r = solution.residuals;
  const double indentation = c.cylinders.profile().gap(solution.half_width());
  document.value("cylinders.residual.contact",
                 Value(r.gap, scientific(1).rounded_up(), units.length).as_is());
  document.value("cylinders.indentation", Value(indentation, scientific(2), units.length).as_is());
  const Limit rounding = Limit(1e-11, LimitKind::choice, "sums of hundreds of rounded terms");
  const auto at_most = [&](const char* what, double share) {
    return Criterion::at_most(what, Value(share, scientific(1).rounded_up()).as_is(), rounding);
  };
  document.check("contact-conditions",
                 {at_most("residual of eq.~(1a) in contact, over the gap at the edge before "
                          "deformation",
                          r.gap / indentation),
                  at_most("penetration outside, over the same", r.separation / indentation),
                  at_most("residual of equilibrium, over the load", r.load / c.line_load)},
                 "the conditions of contact hold to rounding");
}

Value radius_of(const parameters::CylinderCase& body, const std::string& unit) {
  if (body.radius.is_plane()) return Value::text("∞");
  return Value(1 / body.radius.curvature(), exact(), unit);
}

}  // namespace

void compute_cylinders(Document& document, const Case& from) {
  const ContactCase& c = from.contact;
  const UnitSystem& units = from.units;
  const Hertz hertz(c.cylinders, c.line_load);
  const Problem problem = problem_on(c, line_contact::grid_around(hertz.half_width(), c.n_nodes));
  const Solution solution = line_contact::solve_by_matrix_inversion(problem, c.line_load);
  const double elements = hertz.half_width() / solution.grid.spacing;

  document.value("cylinders.load", Value(c.line_load, exact(), units.line_load));
  document.value("cylinders.radius1", radius_of(c.body1, units.length));
  document.value("cylinders.radius2", radius_of(c.body2, units.length));
  document.value("cylinders.relative-radius",
                 Value(1 / c.cylinders.relative_curvature(), significant(4), units.length).as_is());
  document.value("cylinders.modulus",
                 Value(c.cylinders.contact_modulus(), significant(4), units.stress).as_is());
  document.value("cylinders.nodes", Value(c.n_nodes, integer()));
  document.value("cylinders.elements", Value(elements, fixed(1)).as_is());
  document.value("cylinders.in-contact", Value(solution.n_in_contact(), integer()));
  document.value("cylinders.solves", Value(solution.work.revisions, integer()));
  document.value("cylinders.hertz.half-width",
                 Value(hertz.half_width(), significant(5), units.length).as_is());
  document.value("cylinders.hertz.peak",
                 Value(hertz.peak_pressure(), significant(6), units.stress).as_is());
  const double curvature =
      std::max(std::abs(c.body1.radius.curvature()), std::abs(c.body2.radius.curvature()));
  document.value("cylinders.half-width-over-radius",
                 Value(hertz.half_width() * curvature, percent(1)).as_is());
  document.value("cylinders.approach",
                 Value(solution.approach(c.datum), significant(4), units.length).as_is());
  document.value("cylinders.datum", Value(c.datum, exact(), units.length));
  document.value("cylinders.sweep.grids", Value(n_grids, integer()));
  document.figure("cylinder-pressure", pressure_figure(solution, hertz));
  check_conditions(document, c, solution, units);
  compare_methods(document, c, hertz, problem, solution);
  compare_with_hertz(document, from, hertz, sweep_edge(c, hertz, elements));
  if (!from.printed_data) return;
  document.claim(
      "friction-small-loss",
      {.route = "Dundurs's second constant of the two materials of the paper: where it "
                "is zero, friction changes neither the pressure nor the position and width "
                "of the contact",
       .expected = Verdict::holds,
       .criteria = {Criterion::agrees(
           "the constant",
           Value(elasticity::dundurs_beta(c.body1.material, c.body2.material), significant(2))
               .as_is(),
           Value(0, exact()), Limit(1e-12, LimitKind::theory, "rounding: like materials"))}});
}

}  // namespace paper
