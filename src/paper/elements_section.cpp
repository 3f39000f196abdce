// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "elasticity/concentrated_load.hpp"
#include "elasticity/load_shapes.hpp"
#include "line_contact/element.hpp"
#include "line_contact/fft_solver.hpp"
#include "paper/bounds.hpp"
#include "paper/convergence.hpp"
#include "paper/edge_study.hpp"
#include "paper/element_quality.hpp"
#include "paper/sections.hpp"

namespace paper {
namespace {

using line_contact::Element;

// An element of load 1 at x = 0 and its influence: the displacement −T and its gradient −T′.
Figure element_figure() {
  const elasticity::Material unit(2 / std::acos(-1.0), 0);  // K = load: 2/(πE) = 1
  constexpr double end = 2.5;
  constexpr int n = 500;
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
    point.push_back(at_force ? literate::gap : elasticity::normal_displacement(unit, force, x, 1));
    uniform_u.push_back(-line_contact::influence_coefficient(Element::uniform, x));
    triangular_u.push_back(-line_contact::influence_coefficient(Element::triangular, x));
    const bool at_end = i == 2 * n / 5 || i == 3 * n / 5;  // |x| = 1/2
    point_slope.push_back(at_force ? literate::gap : elasticity::normal_gradient(unit, force, x));
    uniform_slope.push_back(at_end ? literate::gap : elasticity::normal_gradient(unit, uniform, x));
    triangular_slope.push_back(elasticity::normal_gradient(unit, triangle, x));
  }
  return {.width_cm = 14,
          .height_cm = 5.2,
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

Criterion of_order(const char* what, Estimate order, double expected) {
  return Criterion::agrees(what, Value(order, fixed(2)), Value(expected, exact()),
                           {LimitKind::choice, 0.25, "nearer to it than to any other half order"});
}

// The mean errors of one kind of element between and beneath the nodes, on grids between whose
// nodes the edge of the contact lies anywhere.
struct QualityStudy {
  std::vector<double> elements, slope, shear, slope_bounds, shear_bounds;

  Estimate finest_slope() const { return {slope.back(), slope_bounds.back()}; }
  Estimate finest_shear() const { return {shear.back(), shear_bounds.back()}; }
  Estimate slope_order() const { return fit_power(elements, slope, slope_bounds).order; }
};

QualityStudy study_quality(const ContactCase& c, const Hertz& hertz, Element element,
                           long coarsest) {
  QualityStudy study;
  constexpr long finest = 89;  // a/c = 40.45
  for (long n_nodes = coarsest; n_nodes <= finest; n_nodes += 4) {
    const line_contact::Solution solution = solve_cylinders(c, hertz, element, n_nodes);
    const ElementQuality quality = quality_of(c, hertz, solution);
    // Pressures that are wrong by δp₀ move the slope by (2/π)(ln N + 1)δ a/R at most, five for any
    // N up to 500, and the shear by less.
    const double bound = 5 * pressure_error(solution) + rounded(c, 1);
    study.elements.push_back(hertz.half_width() / solution.grid.spacing);
    study.slope.push_back(quality.slope.value);
    study.shear.push_back(quality.shear.value);
    study.slope_bounds.push_back(quality.slope.abs_error + bound);
    study.shear_bounds.push_back(quality.shear.abs_error + bound);
  }
  return study;
}

// What each kind of element says between and beneath the nodes of the same contact. The slope that
// forces make has no mean: beside each of them it goes with 1/x.
void register_quality(Document& document, const ContactCase& c, const Hertz& hertz) {
  const QualityStudy point = study_quality(c, hertz, Element::point, 89);
  const QualityStudy uniform = study_quality(c, hertz, Element::uniform, 21);
  const QualityStudy triangular = study_quality(c, hertz, Element::triangular, 21);
  const auto error = [&](const char* key, Estimate value) {
    document.value(key, Value(value, scientific(1)));
  };
  document.value("elements.count", Value(closed_form(uniform.elements.back()), fixed(1)));
  error("elements.slope.uniform", uniform.finest_slope());
  error("elements.shear.point", point.finest_shear());
  error("elements.shear.uniform", uniform.finest_shear());
  const Estimate slope_gain = uniform.finest_slope() / triangular.finest_slope();
  const Estimate shear_gain = uniform.finest_shear() / triangular.finest_shear();
  document.value("elements.slope-gain", Value(slope_gain, significant(2)));
  document.value("elements.shear-gain", Value(shear_gain, significant(2)));
  document.claim(
      "triangles-gain-between-nodes",
      {.route = "powers fitted to the mean of |slope + 𝑥/𝑅| over |𝑥| ≤ 0.9𝑎 on grids "
                "of 10 to 40 elements over the half-width",
       .expected = Verdict::confirmed,
       .criteria = {Criterion::at_least(
                        "order of triangles", Value(triangular.slope_order(), fixed(2)),
                        {LimitKind::choice, 1.75, "nearer to 2 than to any lower half order"}),
                    of_order("of uniform elements", uniform.slope_order(), 1)}});
  document.value("elements.slope-order", Value(triangular.slope_order(), fixed(1)));
  const auto better = [&](const char* what, Estimate worse, Estimate best) {
    return Criterion::at_least(what, Value(worse / best, significant(2)),
                               {LimitKind::choice, 10.0, "an order of magnitude"});
  };
  document.check(
      "triangles-gain-in-slopes-and-stresses",
      {better("slopes, uniform over triangles", uniform.finest_slope(), triangular.finest_slope()),
       better("stresses, forces over uniform", point.finest_shear(), uniform.finest_shear()),
       better("stresses, uniform over triangles", uniform.finest_shear(),
              triangular.finest_shear())},
      "slopes and stresses near the surface are best with triangles");
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
    {"pressure, largest error", "0.5", 0.5, &ConvergenceStudy::largest,
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

// The error inside on very fine grids over what the fitted power makes of it: root mean squares, as
// those that were fitted.
Estimate finest_over_fit(Document& document, const ContactCase& c, const Hertz& hertz,
                         const PowerFit& inside) {
  constexpr long n_nodes = 1L << 16;
  // Rounding leaves up to a few 1e-12 on so many nodes, by the radii; the error inside is 1e-10.
  constexpr double tolerance = 1e-11;
  double squares = 0;
  double bound = 0;
  for (const line_contact::Grid& grid : grids_of(hertz, n_nodes)) {
    const line_contact::Solution solution = line_contact::solve_by_fft(
        {c.cylinders.profile(), c.cylinders.contact_modulus(), grid, Element::triangular},
        c.line_load, tolerance);
    const HertzErrors errors = errors_against(hertz, solution);
    const double fitted = inside.factor.value * std::pow(errors.elements, -inside.order.value);
    squares += std::pow(errors.inside / fitted, 2) / n_edge_places;
    bound = std::max(bound, (pressure_error(solution) + rounded(c, 1)) / fitted);
  }
  const double ratio = std::sqrt(squares);
  const Estimate of_fit{ratio, bound + of_factors * ratio};
  document.value("large.over-fit", Value(of_fit, fixed(1)));
  document.value("large.n-grids", Value(n_edge_places, integer()));
  return of_fit;
}

void claim_orders(Document& document, PowerFit inside, double ratio, Estimate finest) {
  const Limit eighth(LimitKind::choice, 2.0,
                     "an eighth of an order, from the middle of the 80 grids to these");
  document.claim(
      "pressure-at-the-nodes",
      {.route =
           "the errors against Hertz over |𝑥| ≤ 0.9𝑎 on 80 grids of 15 to 750 elements over "
           "the half-width, and on ten that are as fine as the finest of the large grids, as root "
           "mean squares over ten neighbouring grids each",
       .expected = Verdict::confirmed,
       .criteria = {
           of_order("order of triangles", inside.order, 2),
           Criterion::at_most("error on the finest grids, over that of the fit",
                              Value(finest, fixed(1)), eighth),
           Criterion::at_least("factor 𝐵 of triangles over that of uniform elements",
                               Value({ratio, of_factors * ratio}, significant(2)),
                               {LimitKind::choice, 0.8, "less would be a gain of a fifth"})}});
}

// Neighbouring grids whose errors are shown together.
constexpr std::size_t n_neighbours = 10;

// How many times as large as the smallest the largest error inside is on grids that differ in where
// the edge of the contact falls between two nodes, and hardly in anything else.
void register_spread(Document& document, const ContactCase& c, const Hertz& hertz) {
  constexpr long n_nodes = 177;
  constexpr int n_places = 100;  // the least error is a narrow one
  constexpr double tolerance = 1e-12;
  std::vector<double> elements, errors;
  double bound = 0;
  for (const line_contact::Grid& grid : grids_of(hertz, n_nodes, n_places)) {
    const line_contact::Solution solution = line_contact::solve_by_fft(
        {c.cylinders.profile(), c.cylinders.contact_modulus(), grid, Element::triangular},
        c.line_load, tolerance);
    const HertzErrors e = errors_against(hertz, solution);
    elements.push_back(e.elements);
    errors.push_back(e.inside);
    bound = std::max(bound, pressure_error(solution) + rounded(c, 1));
  }
  const auto [least, most] = std::ranges::minmax(errors);
  document.value("elements.spread",
                 Value(Estimate{most, bound} / Estimate{least, bound}, significant(2)));
  document.value("elements.spread.n-grids", Value(n_places, integer()));
  document.value("elements.spread.least", Value(closed_form(elements.front()), fixed(1)));
  document.value("elements.spread.most", Value(closed_form(elements.back()), fixed(1)));
}

void register_orders(Document& document, const ContactCase& c, const Hertz& hertz,
                     const ConvergenceStudy& triangular, const ConvergenceStudy& uniform) {
  literate::Table table(
      "element-orders",
      {Column::text("error of"), Column::text("expected"),
       Column("$r$", fixed(2)).under("triangles"), Column("$B$", fixed(2)).under("triangles"),
       Column("$r$", fixed(2)).under("uniform"), Column("$B$", fixed(2)).under("uniform")});
  const auto fit = [](const ConvergenceStudy& study, const Quantity& quantity) {
    return fit_power(study.elements, study.*quantity.errors,
                     quantity.bounds == nullptr ? std::vector<double>{} : study.*quantity.bounds);
  };
  std::vector<Criterion> orders;
  for (const Quantity& quantity : quantities) {
    const PowerFit first = fit(triangular, quantity);
    const PowerFit second = fit(uniform, quantity);
    for (const PowerFit& power : {first, second}) {
      orders.push_back(of_order(quantity.name, power.order, quantity.expected));
    }
    table.add_row({quantity.name, literate::Cell::latex(quantity.expected_text), first.order,
                   first.factor, second.order, second.factor});
  }
  document.table(std::move(table));
  document.check("orders-of-convergence", orders,
                 "all errors of contact converge with the expected orders");
  const PowerFit inside = fit_power(triangular.elements, triangular.inside);
  const PowerFit uniform_inside = fit_power(uniform.elements, uniform.inside);
  claim_orders(document, inside, inside.factor.value / uniform_inside.factor.value,
               finest_over_fit(document, c, hertz, inside));
  const auto n = static_cast<long>(triangular.elements.size());
  document.value("elements.n-grids", Value(n, integer()));
  const double inside_ratio = inside.factor.value / uniform_inside.factor.value;
  document.value("elements.inside-ratio",
                 Value({inside_ratio, of_factors * inside_ratio}, significant(2)));
  register_spread(document, c, hertz);
  document.value("elements.coarsest", Value(closed_form(triangular.elements.front()), fixed(0)));
  document.value("elements.finest", Value(closed_form(triangular.elements.back()), fixed(0)));
}

// The least and the greatest of the errors on each ten neighbouring grids: between two grids the
// errors jump, as the edge of the contact falls elsewhere between two nodes.
FigureData band(const std::vector<double>& elements, const std::vector<double>& errors) {
  std::vector<double> middle, least, greatest;
  for (std::size_t i = 0; i + n_neighbours <= elements.size(); i += n_neighbours) {
    const auto begin = errors.begin() + static_cast<std::ptrdiff_t>(i);
    const auto [low, high] = std::minmax_element(begin, begin + n_neighbours);
    middle.push_back(std::sqrt(elements[i] * elements[i + n_neighbours - 1]));
    least.push_back(*low);
    greatest.push_back(*high);
  }
  return {{"elements", middle}, {"least", least}, {"greatest", greatest}};
}

}  // namespace

void compute_elements(Document& document, const Case& from) {
  const ContactCase& c = from.contact;
  const Hertz hertz(c.cylinders, c.line_load);
  document.figure("element-kinds", element_figure());
  register_quality(document, c, hertz);
  const ConvergenceStudy triangular = convergence_study(c, hertz, Element::triangular);
  const ConvergenceStudy uniform = convergence_study(c, hertz, Element::uniform);
  register_orders(document, c, hertz, triangular, uniform);
  const EdgeErrors graded = study_edge(document, c, hertz);
  document.figure(
      "pressure-convergence",
      {.width_cm = 14,
       .height_cm = 5.4,
       .data = {{"largest", band(triangular.elements, triangular.largest)},
                {"inside", band(triangular.elements, triangular.inside)},
                {"graded", {{"elements", graded.elements}, {"largest", graded.largest}}}}});
}

}  // namespace paper
