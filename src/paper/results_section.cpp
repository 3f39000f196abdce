// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>
#include <optional>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "elasticity/surface_quadrature.hpp"
#include "paper/bounds.hpp"
#include "paper/conventions.hpp"
#include "paper/paper.hpp"
#include "paper/printed_data.hpp"

namespace paper {
namespace {

double analytical(const HalfSpaceCase& c, double x) {
  return normal_displacement(c.material, c.load, x, c.datum);
}

std::vector<double> values_of(const std::vector<PrintedNumber>& printed) {
  std::vector<double> values;
  for (const PrintedNumber& number : printed) values.push_back(number.value());
  return values;
}

// u_z by eq. (3) as a smooth curve, and what the paper prints of it, where the case has that.
Figure comparison_figure(const HalfSpaceCase& c, const UnitSystem& units,
                         const std::optional<PrintedData>& printed_data) {
  std::vector<double> curve_x, u_z;
  constexpr int n = 300;
  const double end = 1.2 * c.farthest_point();
  for (int i = 0; i <= n; ++i) {
    curve_x.push_back(end * i / n);
    u_z.push_back(analytical(c, curve_x.back()));
  }
  Figure figure{.width_cm = 12.5,
                .height_cm = 6,
                .data = {{"curve", {{"x", curve_x}, {"u_z", u_z}}}},
                .numbers = {{"half_width", c.load.half_width()}},
                .texts = {{"unit", units.length}}};
  if (printed_data) {
    const PrintedFigure5& printed = printed_data->figure5;
    figure.data["printed"] = {{"x", values_of(printed.x)},
                              {"analytical", values_of(printed.analytical)},
                              {"fea_z", values_of(printed.fea_z)},
                              {"fea_magnitude", values_of(printed.fea_magnitude)}};
  }
  return figure;
}

// Left and right by eq. (2), where nothing is known of the symmetry.
void check_symmetry(Document& document, const HalfSpaceCase& c) {
  const elasticity::SurfaceQuadrature surface(c.material, c.load, c.datum);
  const double unit = c.material.integral_compliance() * c.load.line_load();
  Estimate largest;
  for (const double x : c.points) {
    largest = max(largest,
                  1 / unit * abs(surface.normal_displacement(x) - surface.normal_displacement(-x)));
  }
  document.check(
      "symmetric",
      {Criterion::at_most("largest difference between left and right, over K",
                          Value(largest, scientific(1).rounded_up()),
                          {LimitKind::choice, 1e-10,
                           "ten digits of the scale K, for which the quadrature is written"})},
      "the displacement by quadrature is the same at x and at -x");
}

// Eq. (3) at the points, for a case that has no printed data to stand beside.
void tabulate_displacements(Document& document, const HalfSpaceCase& c, const UnitSystem& units) {
  literate::Table table("displacements",
                        {Column("$x$", fixed(decimals_of(c.points)), units.length).exact(),
                         Column("$u_z$, eq.~(3)", significant(8), units.length),
                         Column("$\\partial u_z/\\partial x$", significant(8))});
  for (const double x : c.points) table.add_row({x, displacement(c, x), gradient(c, x)});
  document.table(table);
}

// The point whose printed value is farthest from eq. (3), in units of its last place.
void describe_odd_point(Document& document, const HalfSpaceCase& c, const UnitSystem& units,
                        const PrintedData& printed_data, std::size_t i) {
  const std::string& unit = units.length;
  const double x = c.points[i];
  const Estimate exact = displacement(c, x);
  const Estimate slope = gradient(c, x);
  const Estimate shift = abs(displacement(c, x + printed_data.tri_dist.step.value()) - exact);
  // The printed number is meant as it stands, not as the interval of what rounds to it.
  const double printed = printed_data.figure5.analytical[i].value();
  const Estimate low = abs(printed - exact);
  document.value("tri-dist.odd.x", Value(closed_form(x), fixed(decimals_of(c.points)), unit));
  document.value("tri-dist.odd.shift", Value(shift, scientific(2), unit));
  document.value("figure5.odd.difference", Value(low, scientific(2), unit));
  document.value("tri-dist.odd.slope", Value(slope, scientific(3)));
}

// How far a number is from one that is printed, which it must round to.
Criterion from_print(const PrintedNumber& printed, Estimate computed) {
  return Criterion::at_most(
      "distance", Value(1 / printed.last_place() * abs(computed - printed.value()), significant(2)),
      {LimitKind::data, 0.5, "every printed digit: the computed value rounds to the printed one"});
}

Criterion rounds_to_print(const std::string& what, const std::vector<Criterion>& points) {
  return Criterion::in_each(what + ", in units of the last printed place", "points", points);
}

// Which load the listed program's output shows, and which one the run of Appendix 2 reports.
void claim_load(Document& document, const HalfSpaceCase& c, const UnitSystem& units,
                const PrintedData& printed_data) {
  const PrintedNumber& first = printed_data.tri_dist.displacement.front();
  const Estimate in_output = as_estimate(first) / displacement(c, c.points.front());
  const Estimate load = c.load.line_load() * in_output;
  const Estimate peak = c.load.peak_pressure() * in_output;
  constexpr double stated = 1000;
  const auto& run = printed_data.appendix2.measures;
  const Value in_words = Value(stated, exact(), units.line_load);
  const Limit apart(LimitKind::choice, 1e-2,
                    "the printed digits leave much less open, and the two readings differ by much "
                    "more");
  document.claim(
      "load-in-words",
      {.route = "the program: the first printed displacement over that of eq. (3) under unit "
                "load; the finite-element run: what its summary prints; a pressure times the unit "
                "thickness of a plane model is a force per length of edge",
       .expected = Verdict::partly,
       .criteria = {
           Criterion::agrees_relatively("the program's peak 𝑝₀, on unit thickness",
                                        Value(peak, significant(4), units.line_load), in_words,
                                        apart),
           Criterion::agrees_relatively(
               "the run's largest vertical stress as printed, on unit thickness",
               Value(abs(as_estimate(run.at("max_stress_yy"))), significant(4), units.line_load),
               in_words, apart),
           Criterion::agrees_relatively("the program's whole load 𝑃",
                                        Value(load, significant(4), units.line_load), in_words,
                                        apart),
           Criterion::agrees_relatively(
               "the run's resultant",
               Value(abs(as_estimate(run.at("resultant_load_y"))), significant(4), units.line_load),
               in_words, apart)}});
  // a pressure on a model of unit thickness, per length of its edge
  document.value("load-in-words.per-edge", Value(c.load.peak_pressure(), exact(), units.line_load));
  document.value("load-in-words.factor", Value(Estimate{stated, 0} / load, significant(3)));
}

// The program's output against eq. (3), at the point and where the program really took it.
std::vector<Criterion> compare_tri_dist(Document& document, const HalfSpaceCase& c,
                                        const UnitSystem& units, const PrintedData& printed_data) {
  const PrintedTriDist& printed = printed_data.tri_dist;
  long n_agree = 0;
  long n_agree_stepped = 0;
  std::vector<Criterion> at_point, at_step;
  double largest_off = 0;
  std::size_t odd = 0;
  for (std::size_t i = 0; i < c.points.size(); ++i) {
    const double x = c.points[i];
    // The program replaces its first and third abscissa by ones that avoid the logarithm of zero.
    const bool steps_off =
        x == 0 || std::abs(x - c.load.half_width()) < 1e-12 * c.load.half_width();
    const double exact = analytical(c, x);
    const double stepped_x = steps_off ? x + printed.step.value() : x;
    const PrintedNumber& digits = printed.displacement[i];
    at_point.push_back(from_print(digits, displacement(c, x)));
    at_step.push_back(from_print(digits, displacement(c, stepped_x)));
    n_agree += digits.agrees_with(exact);
    n_agree_stepped += digits.agrees_with(analytical(c, stepped_x));
    const double off = std::abs(digits.value() - exact) / digits.last_place();
    if (off > largest_off) {
      largest_off = off;
      odd = i;
    }
  }
  describe_odd_point(document, c, units, printed_data, odd);
  document.value("tri-dist.n-agree", Value(n_agree, integer()));
  document.value("tri-dist.n-agree-stepped", Value(n_agree_stepped, integer()));
  document.value("tri-dist.step", Value(printed.step.value(), exact(), units.length));
  document.check("tri-dist-steps-off",
                 {rounds_to_print("eq. (3) less the program's output, there", at_step)},
                 "where the listing evaluates it, eq. (3) has every digit of its output");
  document.value("tri-dist.n-digits", Value(printed.displacement.front().n_digits(), integer()));
  return {rounds_to_print("eq. (3) less the program's output", at_point),
          rounds_to_print("eq. (3) at the abscissae that the listing assigns, less that output",
                          at_step)};
}

// The finite-element column of Fig. 5 against the summary of the run, digit by digit.
void check_measures(Document& document, const PrintedData& printed_data) {
  const std::vector<PrintedNumber>& fea_z = printed_data.figure5.fea_z;
  std::vector<Criterion> same;
  for (std::size_t i = 0; i < fea_z.size(); ++i) {
    const PrintedNumber& measure =
        printed_data.appendix2.measures.at(fmt::format("measure{}", i + 1));
    const double unit = std::min(fea_z[i].last_place(), measure.last_place());
    const double apart = std::round(std::abs(fea_z[i].value() + measure.value()) / unit);
    same.push_back(Criterion::at_most("difference", Value(apart, fixed(0)).as_is(),
                                      {LimitKind::data, 0.0, "the same digits"}));
  }
  document.check("fea-z-are-measures",
                 {Criterion::in_each("difference in units of the last place", "points", same)},
                 "the column FEA (𝑧) of Fig. 5 has the digits of measure1, measure2, … of the "
                 "run's summary");
}

// Decimal fractions as doubles, in units of the last of seven places.
constexpr double rounding_of_print = 1e-8;

// Fig. 5 rebuilt: the analytical column from eq. (3), the error column from the other columns, and
// the tangential displacement that they imply.
Criterion compare_figure5(Document& document, const HalfSpaceCase& c, const UnitSystem& units,
                          const PrintedData& printed_data) {
  const PrintedFigure5& printed = printed_data.figure5;
  const std::string& unit = units.length;
  const auto column = [&](const char* heading, int exponent, int n_decimals) {
    return Column(heading, fixed(n_decimals), unit).scaled(exponent);
  };
  constexpr int micro = -6, error_unit = -8;
  const char* const group = "printed in Fig.~5";
  literate::Table table(
      "figure5",
      {Column("$x$", fixed(decimals_of(c.points)), unit),
       column("FEA, mag.", micro, 6).under(group), column("FEA, $z$", micro, 6).under(group),
       column("analytical", micro, 6).under(group), column("error", error_unit, 3).under(group),
       column("eq.~(3)", micro, 6), column("$|$eq.~(3)$\\,-\\,$FEA, $z|$", error_unit, 3),
       column("$|u_x|$", error_unit, 2)});
  long n_analytical = 0;
  std::vector<Criterion> analytical_points, errors_of_magnitude, errors_of_z;
  for (std::size_t i = 0; i < c.points.size(); ++i) {
    const double exact = analytical(c, c.points[i]);
    const Estimate u_z = displacement(c, c.points[i]);
    table.add_row({quoted(printed.x[i]), quoted(printed.fea_magnitude[i]), quoted(printed.fea_z[i]),
                   quoted(printed.analytical[i]), quoted(printed.error[i]), u_z,
                   abs(u_z - as_estimate(printed.fea_z[i])),
                   other_component(printed.fea_magnitude[i], printed.fea_z[i])});
    n_analytical += printed.analytical[i].agrees_with(exact);
    analytical_points.push_back(from_print(printed.analytical[i], displacement(c, c.points[i])));

    // The error column is the difference of two printed columns: of which? It carries more digits
    // than they do, so it may be off by their last places.
    const double unit_of_place = printed.analytical[i].last_place();
    const auto explains = [&](const PrintedNumber& fea) {
      const double difference = std::abs(printed.analytical[i].value() - fea.value());
      const double off = std::abs(difference - printed.error[i].value()) / unit_of_place;
      return Criterion::at_most("difference", Value({off, rounding_of_print}, significant(2)),
                                {LimitKind::data, 1.0,
                                 "the error column has more digits than the columns, of which each "
                                 "is known to half a unit"});
    };
    errors_of_magnitude.push_back(explains(printed.fea_magnitude[i]));
    errors_of_z.push_back(explains(printed.fea_z[i]));
  }
  document.table(table);
  document.claim(
      "error-of-z",
      {.route = "the difference of the printed columns, analytical less FEA (𝑧)",
       .expected = Verdict::refuted,
       .criteria = {Criterion::in_each("that difference less the printed error, in units of the "
                                       "columns' last place",
                                       "points", errors_of_z)}});
  check_measures(document, printed_data);
  document.value("figure5.n-analytical", Value(n_analytical, integer()));
  document.value("figure5.n-errors-of-magnitude", Value(n_holding(errors_of_magnitude), integer()));
  document.value("figure5.n-errors-of-z", Value(n_holding(errors_of_z), integer()));
  document.check(
      "figure5-error-column",
      {Criterion::in_each("analytical less magnitude less error, in units of the last place",
                          "points", errors_of_magnitude)},
      "the error column of Fig. 5 is the difference from the FEA magnitude everywhere");
  return rounds_to_print("eq. (3) less the analytical column of Fig. 5", analytical_points);
}

}  // namespace

void compute_results(Document& document, const Case& from) {
  const HalfSpaceCase& c = from.half_space;
  const UnitSystem& units = from.units;
  const std::optional<PrintedData>& printed_data = from.printed_data;
  // With a block, the figure of the error analysis has the printed columns.
  if (!printed_data || !from.block) {
    document.figure("displacement-comparison", comparison_figure(c, units, printed_data));
  }
  check_symmetry(document, c);
  if (printed_data) {
    claim_load(document, c, units, *printed_data);
    std::vector<Criterion> digits = compare_tri_dist(document, c, units, *printed_data);
    digits.push_back(compare_figure5(document, c, units, *printed_data));
    document.claim("tri-dist-is-equation-3",
                   {.route = "eq. (3) as this report evaluates it, with its limits at 𝑥 = 0 and "
                             "𝑥 = ±𝑎, against every printed digit",
                    .expected = Verdict::partly,
                    .criteria = std::move(digits)});
  } else {
    tabulate_displacements(document, c, units);
  }
}

}  // namespace paper
