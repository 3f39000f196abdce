// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <cmath>
#include <vector>

#include "paper/conventions.hpp"
#include "paper/paper.hpp"

namespace paper {
namespace {

// Eq. (3) as a curve and at the points, for a case without printed data.
void show_displacement(Document& document, const HalfSpaceCase& c, const UnitSystem& units) {
  std::vector<double> curve_x, u_z;
  constexpr int n = 300;
  for (int i = 0; i <= n; ++i) {
    curve_x.push_back(1.2 * c.farthest_point() * i / n);
    u_z.push_back(displacement(c, curve_x.back()).value);
  }
  document.figure("displacement", {.width_cm = 11,
                                   .height_cm = 5,
                                   .data = {{"curve", {{"x", curve_x}, {"u_z", u_z}}}},
                                   .numbers = {{"half_width", c.load.half_width()}},
                                   .texts = {{"unit", units.length}}});
  literate::Table table("displacements", {column_of_points(c.points, units.length),
                                          Column("$u_z$, eq.~(3)", significant(8), units.length),
                                          Column("$\\partial u_z/\\partial x$", significant(8))});
  for (const double x : c.points) table.add_row({x, displacement(c, x), gradient(c, x)});
  document.table(table);
}

// The abscissa that Tri_dist.m uses for a point: offset from the two at which it would take ln 0.
double abscissa(const HalfSpaceCase& c, const PrintedTriDist& printed, double x) {
  const bool is_singular = x == 0 || std::abs(x - c.load.half_width()) < 1e-9 * c.load.half_width();
  return is_singular ? x + printed.step.value() : x;
}

// Checks that a computed number rounds to the printed one.
Criterion rounds_to_print(const PrintedNumber& printed, Estimate computed) {
  const Estimate distance = abs(computed - printed.value()) / printed.last_place();
  return Criterion::at_most(
      "distance", Value(distance, significant(2)),
      Limit(0.5, LimitKind::data, "the computed value rounds to every printed digit"));
}

// Compares the program's output and the analytical column with eq. (3) at the program's abscissae.
void claim_program(Document& document, const HalfSpaceCase& c, const UnitSystem& units,
                   const PrintedData& printed) {
  std::vector<Criterion> output, column;
  for (std::size_t i = 0; i < c.points.size(); ++i) {
    const double x = c.points[i];
    const Estimate there = displacement(c, abscissa(c, printed.tri_dist, x));
    output.push_back(rounds_to_print(printed.tri_dist.displacement[i], there));
    column.push_back(rounds_to_print(printed.figure5.analytical[i], there));
  }
  document.claim(
      "tri-dist-is-equation-3",
      {.route = "eq.~(3) at the abscissae that the listing assigns, against every printed digit",
       .expected = Verdict::holds,
       .criteria = {
           Criterion::in_each("difference from the program's output, in units of its last place",
                              "points", output),
           Criterion::in_each("from the analytical column", "points", column)}});
  document.value("tri-dist.n-digits",
                 Value(printed.tri_dist.displacement.front().n_digits(), integer()));
  document.value("tri-dist.step", Value(printed.tri_dist.step.value(), exact(), units.length));
  const double end = c.load.half_width();
  const Estimate shift =
      abs(displacement(c, abscissa(c, printed.tri_dist, end)) - displacement(c, end));
  document.value("tri-dist.odd.shift", Value(shift, scientific(2), units.length));
}

// The loads that follow from the listed program's output and from the run's summary.
void claim_load(Document& document, const HalfSpaceCase& c, const UnitSystem& units,
                const PrintedData& printed) {
  const Estimate in_output =
      as_estimate(printed.tri_dist.displacement.front()) / displacement(c, 0);
  constexpr double stated = 1000;  // «A 1000 pound/inch load»
  const auto agrees = [&](const char* what, Estimate load) {
    return Criterion::agrees_relatively(
        what, Value(load, significant(4), units.line_load), Value(stated, exact(), units.line_load),
        Limit(1e-2, LimitKind::choice, "the two readings differ by much more"));
  };
  const Estimate load = c.load.line_load() * in_output;
  document.claim(
      "load-in-words",
      {.route = "the program: its first displacement over that of eq.~(3); the run: its summary; a "
                "pressure on unit thickness is a force per length of edge",
       .expected = Verdict::holds_in_part,
       .criteria = {
           agrees("the program's peak pressure, on unit thickness",
                  c.load.peak_pressure() * in_output),
           agrees("the run's largest vertical stress, on unit thickness",
                  abs(as_estimate(measure(printed, "max_stress_yy")))),
           agrees("the program's whole load", load),
           agrees("the run's resultant", abs(as_estimate(measure(printed, "resultant_load_y"))))}});
  document.value("load-in-words.per-edge", Value(c.load.peak_pressure(), exact(), units.line_load));
  document.value("load-in-words.factor", Value(stated / load, significant(3)));
}

// Compares the columns of Fig. 5 with ours, and finds which difference its error column is.
void compare_figure5(Document& document, const HalfSpaceCase& c, const UnitSystem& units,
                     const PrintedFigure5& printed) {
  const auto column = [&](const char* heading, int exponent, int n_decimals) {
    return Column(heading, fixed(n_decimals), units.length).scaled(exponent);
  };
  constexpr int micro = -6, error_unit = -8;
  const char* const group = "printed in Fig.~5";
  literate::Table table(
      "figure5",
      {column_of_points(c.points, units.length), column("FEA, mag.", micro, 6).under(group),
       column("FEA, $z$", micro, 6).under(group), column("analytical", micro, 6).under(group),
       column("error", error_unit, 3).under(group), column("eq.~(3)", micro, 6),
       column("$|$eq.~(3)$\\,-\\,$FEA, $z|$", error_unit, 3), column("$|u_x|$", error_unit, 2)});
  // The error column has more digits than the other columns, each known to half a unit.
  const auto explains = [&](std::size_t i, const std::vector<PrintedNumber>& fea) {
    const double difference = std::abs(printed.analytical[i].value() - fea[i].value());
    const double off =
        std::abs(difference - printed.error[i].value()) / printed.analytical[i].last_place();
    return Criterion::at_most("difference", Value(off, significant(2)).as_is(),
                              Limit(1, LimitKind::data,
                                    "each of the two columns is known to half a unit of its last "
                                    "place"));
  };
  std::vector<Criterion> of_magnitude, of_z;
  for (std::size_t i = 0; i < c.points.size(); ++i) {
    const Estimate u_z = displacement(c, c.points[i]);
    table.add_row({quoted(printed.x[i]), quoted(printed.fea_magnitude[i]), quoted(printed.fea_z[i]),
                   quoted(printed.analytical[i]), quoted(printed.error[i]), u_z,
                   abs(u_z - as_estimate(printed.fea_z[i])),
                   other_component(printed.fea_magnitude[i], printed.fea_z[i])});
    of_magnitude.push_back(explains(i, printed.fea_magnitude));
    of_z.push_back(explains(i, printed.fea_z));
  }
  document.table(table);
  document.claim(
      "error-of-z",
      {.route = "the difference of the printed columns, analytical minus FEA $z$",
       .expected = Verdict::fails,
       .criteria = {Criterion::in_each(
           "that difference minus the printed error, in units of the columns' last place", "points",
           of_z)}});
  document.check("figure5-error-column",
                 {Criterion::in_each("analytical minus magnitude minus error, in units of the last "
                                     "place",
                                     "points", of_magnitude)},
                 "the error column of Fig. 5 is the difference from the FEA magnitude everywhere");
}

// Compares the finite-element column of Fig. 5 with the summary of the run, digit by digit.
void check_measures(Document& document, const PrintedData& printed) {
  bool agree = true;
  for (std::size_t i = 0; i < printed.figure5.fea_z.size(); ++i) {
    const PrintedNumber in_summary = measure(printed, fmt::format("measure{}", i + 1));
    agree = agree && -in_summary.value() == printed.figure5.fea_z[i].value();
  }
  document.check("fea-z-are-measures", agree,
                 "the FEA displacements in z are the measures of the run's summary");
}

}  // namespace

void compute_results(Document& document, const Case& from) {
  const HalfSpaceCase& c = from.half_space;
  show_displacement(document, c, from.units);
  if (!from.printed_data) return;
  const PrintedData& printed = *from.printed_data;
  claim_program(document, c, from.units, printed);
  claim_load(document, c, from.units, printed);
  compare_figure5(document, c, from.units, printed.figure5);
  check_measures(document, printed);
}

}  // namespace paper
