// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "contact/element.hpp"
#include "contact/graded_contact.hpp"
#include "elasticity/concentrated_load.hpp"
#include "elasticity/uniform_load.hpp"
#include "literate/document/document.hpp"
#include "numerics/power_fit.hpp"
#include "paper/bounds.hpp"
#include "paper/convergence.hpp"
#include "paper/element_quality.hpp"
#include "parameters/case.hpp"

namespace paper {
namespace {

using contact::Element;
using contact::Hertz;
using literate::Column;
using literate::Criterion;
using literate::exact;
using literate::fixed;
using literate::integer;
using literate::LimitKind;
using literate::scientific;
using literate::significant;
using literate::Value;
using literate::Verdict;
using numerics::Estimate;
using numerics::fit_power;
using numerics::PowerFit;

// An element of load 1 at x = 0 and its influence: the displacement −T and its gradient −T′.
literate::Figure element_figure() {
  const elasticity::Material unit(2 / std::acos(-1.0), 0);  // K = load: 2/(πE) = 1
  constexpr double end = 2.5;
  constexpr int n = 500;
  constexpr double infinite = std::numeric_limits<double>::quiet_NaN();
  const elasticity::ConcentratedLoad force(1);
  const elasticity::UniformLoad uniform(1, 0.5);
  const elasticity::TriangularLoad triangle(1, 1);
  std::vector<double> abscissae;
  std::vector<double> point, uniform_u, triangular_u;
  std::vector<double> point_slope, uniform_slope, triangular_slope;
  for (int i = 0; i <= n; ++i) {
    const double x = end * (2.0 * i / n - 1);
    const bool at_force = i == n / 2;
    abscissae.push_back(x);
    point.push_back(at_force ? infinite : elasticity::normal_displacement(unit, force, x, 1));
    uniform_u.push_back(-contact::influence_coefficient(Element::uniform, x));
    triangular_u.push_back(-contact::influence_coefficient(Element::triangular, x));
    const bool at_end = i == 2 * n / 5 || i == 3 * n / 5;  // |x| = 1/2
    point_slope.push_back(at_force ? infinite : elasticity::normal_gradient(unit, force, x));
    uniform_slope.push_back(at_end ? infinite : elasticity::normal_gradient(unit, uniform, x));
    triangular_slope.push_back(elasticity::normal_gradient(unit, triangle, x));
  }
  return {.width_cm = 14,
          .height_cm = 6.6,
          .data = {{"displacement",
                    {{"x", abscissae},
                     {"point", point},
                     {"uniform", uniform_u},
                     {"triangular", triangular_u}}},
                   {"gradient",
                    {{"x", abscissae},
                     {"point", point_slope},
                     {"uniform", uniform_slope},
                     {"triangular", triangular_slope}}}}};
}

void claim_quality(literate::Document& document, Estimate gain) {
  document.claim(
      "triangles-gain-between-nodes",
      {.route = "the slope against −x/R of Hertz at eighths between the nodes",
       .expected = Verdict::confirmed,
       .criteria = {Criterion::at_least(
           "largest error with uniform elements over that with triangles",
           Value(gain, significant(2)), {LimitKind::convention, 10.0, "an order of magnitude"})}});
}

// What each kind of element says between and beneath the nodes of the same contact.
void register_quality(literate::Document& document, const parameters::ContactCase& c,
                      const Hertz& hertz) {
  constexpr long n_nodes = 89;  // a/c = 40.45
  literate::Table table("element-quality",
                        {Column::text("elements"), Column::text("displacement").under("at a node"),
                         Column::text("gradient").under("at a node"),
                         Column("slope", scientific(2)).under("largest error of"),
                         Column("shear stress", scientific(2)).under("largest error of")});
  std::vector<ElementQuality> quality;
  std::vector<double> bounds;
  for (const Element element : {Element::point, Element::uniform, Element::triangular}) {
    const contact::Solution solution = solve_cylinders(c, hertz, element, n_nodes);
    quality.push_back(quality_of(c, hertz, solution));
    // Pressures that are wrong by δp₀ move the slope by (2/π)(ln N + 1)δ a/R at most, five for any
    // N up to 500, and the shear by less.
    bounds.push_back(5 * pressure_error(solution) + rounded(c, 1));
    table.add_row({std::string(contact::name_of(element)),
                   element == Element::point ? "infinite" : "finite",
                   element == Element::triangular ? "finite" : "infinite",
                   Estimate{quality.back().slope, bounds.back()},
                   Estimate{quality.back().shear, bounds.back()}});
  }
  const double spacing =
      contact::grid_of_width(cylinder_domain * hertz.half_width(), n_nodes).spacing;
  document.value("elements.count", Value(closed_form(hertz.half_width() / spacing), fixed(1)));
  document.table(std::move(table));
  const auto gain = [&](double ElementQuality::*error) {
    return quotient({quality[1].*error, bounds[1]}, {quality[2].*error, bounds[2]});
  };
  claim_quality(document, gain(&ElementQuality::slope));
  document.value("elements.slope-gain", Value(gain(&ElementQuality::slope), significant(2)));
  document.value("elements.shear-gain", Value(gain(&ElementQuality::shear), significant(2)));
  // That of the slope from uniform elements to triangles is a claim.
  const auto better = [&](const char* what, double ElementQuality::*error, std::size_t i) {
    return Criterion::at_least(
        what,
        Value(quotient({quality[i - 1].*error, bounds[i - 1]}, {quality[i].*error, bounds[i]}),
              significant(2)),
        {LimitKind::convention, 10.0, "an order of magnitude"});
  };
  document.check("triangles-gain-in-slopes-and-stresses",
                 {better("slopes, forces over uniform", &ElementQuality::slope, 1),
                  better("stresses, forces over uniform", &ElementQuality::shear, 1),
                  better("stresses, uniform over triangles", &ElementQuality::shear, 2)},
                 "slopes and stresses near the surface are best with triangles, worst with forces");
}

Criterion of_order(const char* what, Estimate order, double expected) {
  return Criterion::agrees(
      what, Value(order, fixed(2)), Value(expected, exact()).within(0),
      {LimitKind::convention, 0.25, "nearer to it than to any other half order"});
}

using Errors = std::vector<double> ConvergenceStudy::*;

struct Quantity {
  const char* name;
  const char* expected_text;
  double expected;
  Errors errors;
  Errors bounds;  // none: the errors are exact
};

const std::array<Quantity, 6> quantities = {{
    {"pressure, largest error", "$\\tfrac12$", 0.5, &ConvergenceStudy::largest,
     &ConvergenceStudy::of_pressure},
    {"pressure, inside", "2", 2, &ConvergenceStudy::inside, &ConvergenceStudy::of_pressure},
    {"peak", "2", 2, &ConvergenceStudy::peak, &ConvergenceStudy::of_pressure},
    {"half-width by count", "1", 1, &ConvergenceStudy::count, nullptr},
    {"half-width extrapolated", "1", 1, &ConvergenceStudy::extrapolated,
     &ConvergenceStudy::of_edge},
    {"half-width by second moment", "2", 2, &ConvergenceStudy::moment,
     &ConvergenceStudy::of_moment},
}};

// Errors above 1e-6 of pressures that are right to 1e-12, of which the factors are made.
constexpr double of_factors = 1e-6;

void claim_orders(literate::Document& document, PowerFit inside, double ratio) {
  document.claim("interior-order-two",
                 {.route = "a power fitted to the errors against Hertz over |x| ≤ 0.9a on many "
                           "grids",
                  .expected = Verdict::confirmed,
                  .criteria = {of_order("order", inside.order_estimate(), 2)}});
  document.claim("no-gain-in-the-pressure",
                 {.route = "the errors of both against Hertz over |x| ≤ 0.9a",
                  .expected = Verdict::confirmed,
                  .criteria = {Criterion::at_least(
                      "ratio of the factors of (c/a)², triangles over uniform elements",
                      Value({ratio, of_factors * ratio}, significant(2)),
                      {LimitKind::convention, 0.8, "a fifth better would be a gain"})}});
}

void register_orders(literate::Document& document, const ConvergenceStudy& triangular,
                     const ConvergenceStudy& uniform) {
  literate::Table table(
      "element-orders",
      {Column::text("error of"), Column::text("expected"),
       Column("$r$", fixed(2)).under("triangles"), Column("$C$", fixed(2)).under("triangles"),
       Column("$r$", fixed(2)).under("uniform"), Column("$C$", fixed(2)).under("uniform")});
  const auto fit = [](const ConvergenceStudy& study, const Quantity& quantity) {
    return fit_power(study.elements, study.*quantity.errors,
                     quantity.bounds == nullptr ? std::vector<double>{} : study.*quantity.bounds);
  };
  std::vector<Criterion> orders;
  for (const Quantity& quantity : quantities) {
    const PowerFit first = fit(triangular, quantity);
    const PowerFit second = fit(uniform, quantity);
    for (const PowerFit& power : {first, second}) {
      orders.push_back(of_order(quantity.name, power.order_estimate(), quantity.expected));
    }
    table.add_row({quantity.name, literate::Cell::latex(quantity.expected_text),
                   first.order_estimate(), first.factor_estimate(), second.order_estimate(),
                   second.factor_estimate()});
  }
  document.table(std::move(table));
  document.check("orders-of-convergence", orders,
                 "all errors of contact converge with the expected orders");
  const PowerFit inside = fit_power(triangular.elements, triangular.inside);
  const PowerFit uniform_inside = fit_power(uniform.elements, uniform.inside);
  claim_orders(document, inside, inside.factor / uniform_inside.factor);
  const auto n = static_cast<long>(triangular.elements.size());
  document.value("elements.n-grids", Value(n, integer()));
  document.value("elements.coarsest", Value(closed_form(triangular.elements.front()), fixed(0)));
  document.value("elements.finest", Value(closed_form(triangular.elements.back()), fixed(0)));
}

struct Graded {
  std::vector<double> elements, largest, half_width, peak;
};

Graded register_graded(literate::Document& document, const parameters::ContactCase& c,
                       const Hertz& hertz) {
  const double a = hertz.half_width();
  literate::Table table(
      "graded", {Column("elements over $a$", integer()), Column("steps of the edges", integer()),
                 Column("$p$, largest", scientific(2)).under("error of"),
                 Column("peak", scientific(2)).under("error of"),
                 Column("half-width", scientific(2)).under("error of")});
  // Up to 300 elements rounding leaves 2e-6 in the pressures (contact/graded_contact.hpp), which at
  // the edge is 6 times its square in the half-width, as 0.23/n² is of 0.30/n⁴. The peak goes with
  // the load over the half-width.
  constexpr double rounding = 2e-6;
  constexpr double of_half_width = 6 * rounding * rounding;
  Graded graded;
  for (const long n : {12L, 25L, 50L, 100L}) {
    const contact::GradedSolution s = contact::solve_on_graded_grid(
        c.cylinders.profile(), c.cylinders.contact_modulus(), c.line_load, n, {-1.3 * a, 1.3 * a});
    double largest = 0;
    for (Eigen::Index i = 0; i < s.x.size(); ++i) {
      const double error = s.pressure[i] - hertz.pressure(s.x[i]);
      largest = std::max(largest, std::abs(error) / hertz.peak_pressure());
    }
    graded.elements.push_back(static_cast<double>(n));
    graded.largest.push_back(largest);
    graded.half_width.push_back(std::abs(s.half_width() / a - 1));
    graded.peak.push_back(std::abs(s.peak_pressure() / hertz.peak_pressure() - 1));
    table.add_row({n, s.n_iterations, Estimate{largest, rounding},
                   Estimate{graded.peak.back(), of_half_width},
                   Estimate{graded.half_width.back(), of_half_width}});
  }
  document.table(std::move(table));
  const std::vector<double> of_pressure(graded.elements.size(), rounding);
  const std::vector<double> of_width(graded.elements.size(), of_half_width);
  const PowerFit pressure_power = fit_power(graded.elements, graded.largest, of_pressure);
  const PowerFit width_power = fit_power(graded.elements, graded.half_width, of_width);
  document.value("graded.order", Value(pressure_power.order_estimate(), fixed(1)));
  document.value("graded.width-order", Value(width_power.order_estimate(), fixed(1)));
  document.claim("graded-order",
                 {.route = "a power fitted to the largest error of the pressure against Hertz, on "
                           "graded grids of a dozen to a hundred elements",
                  .expected = Verdict::confirmed,
                  .criteria = {Criterion::at_least(
                      "order", Value(pressure_power.order_estimate(), fixed(1)),
                      {LimitKind::convention, 1.5, "the errors inside, of order 2, are next"})}});
  const auto small = [&](const char* what, double error, double limit) {
    return Criterion::at_most(
        what, Value({error, rounding}, scientific(1).rounded_up()),
        {LimitKind::regression, limit, "what was found on the finest grid, with a margin"});
  };
  document.check(
      "graded-grid-removes-the-edge-error",
      {small("largest error of the pressure, over the peak", graded.largest.back(), 1e-4),
       small("of the half-width", graded.half_width.back(), 1e-5),
       small("of the peak", graded.peak.back(), 1e-5)},
      "graded elements have no error of order 1/2 at the edge");
  return graded;
}

}  // namespace

void compute_elements(literate::Document& document, const parameters::ContactCase& c) {
  const Hertz hertz(c.cylinders, c.line_load);
  document.figure("element-kinds", element_figure());
  register_quality(document, c, hertz);
  const ConvergenceStudy triangular = convergence_study(c, hertz, Element::triangular);
  const ConvergenceStudy uniform = convergence_study(c, hertz, Element::uniform);
  register_orders(document, triangular, uniform);
  const Graded graded = register_graded(document, c, hertz);
  document.figure(
      "pressure-convergence",
      {.width_cm = 14,
       .height_cm = 7.6,
       .data = {{"even",
                 {{"elements", triangular.elements},
                  {"triangular_inside", triangular.inside},
                  {"triangular_largest", triangular.largest},
                  {"uniform_inside", uniform.inside},
                  {"uniform_largest", uniform.largest}}},
                {"graded", {{"elements", graded.elements}, {"largest", graded.largest}}}}});
}

}  // namespace paper
