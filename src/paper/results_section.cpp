// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>
#include <optional>

#include <algorithm>
#include <cmath>
#include <vector>

#include "elasticity/surface_quadrature.hpp"
#include "literate/document/document.hpp"
#include "paper/bounds.hpp"
#include "paper/decimals.hpp"
#include "paper/printed_data.hpp"
#include "paper/quoted.hpp"
#include "parameters/case.hpp"

namespace paper {
namespace {

using config::PrintedNumber;
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

double analytical(const parameters::HalfSpaceCase& c, double x) {
  return normal_displacement(c.material, c.load, x, c.datum);
}

std::vector<double> values_of(const std::vector<PrintedNumber>& printed) {
  std::vector<double> values;
  for (const PrintedNumber& number : printed) values.push_back(number.value());
  return values;
}

// u_z by eq. (3) as a smooth curve, and what the paper prints of it, where the case has that.
literate::Figure comparison_figure(const parameters::HalfSpaceCase& c,
                                   const config::UnitSystem& units,
                                   const std::optional<PrintedData>& printed_data) {
  std::vector<double> curve_x, u_z;
  constexpr int n = 300;
  const double end = 1.2 * c.farthest_point();
  for (int i = 0; i <= n; ++i) {
    curve_x.push_back(end * i / n);
    u_z.push_back(analytical(c, curve_x.back()));
  }
  literate::Figure figure{.width_cm = 12.5,
                          .height_cm = 7.6,
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

// Left and right, and far from the load, by eq. (2) alone.
void claim_shape(literate::Document& document, const parameters::HalfSpaceCase& c) {
  const elasticity::SurfaceQuadrature surface(c.material, c.load, c.datum);
  const double unit = c.material.integral_compliance() * c.load.line_load();
  Estimate largest;
  for (const double x : c.points) {
    const Estimate difference =
        1 / unit * magnitude(surface.normal_displacement(x) - surface.normal_displacement(-x));
    largest.value = std::max(largest.value, difference.value);
    largest.abs_error = std::max(largest.abs_error, difference.abs_error);
  }
  document.claim("symmetric",
                 {.route = "eq. (2) by quadrature at x and at −x, where nothing is known of the "
                           "symmetry",
                  .expected = Verdict::confirmed,
                  .criteria = {Criterion::at_most(
                      "largest difference between left and right, over K",
                      Value(largest, scientific(1).rounded_up()),
                      {LimitKind::convention, 1e-10,
                       "ten digits of the scale K, for which the quadrature is written"})}});
}

// Eq. (3) at the points, for a case that has no printed data to stand beside.
void tabulate_displacements(literate::Document& document, const parameters::HalfSpaceCase& c,
                            const config::UnitSystem& units) {
  literate::Table table("displacements",
                        {Column("$x$", fixed(decimals_of(c.points)), units.length).exact(),
                         Column("$u_z$, eq.~(3)", significant(8), units.length),
                         Column("$\\partial u_z/\\partial x$", significant(8))});
  for (const double x : c.points) table.add_row({x, displacement(c, x), gradient(c, x)});
  document.table(table);
}

// The point whose printed value is farthest from eq. (3), in units of its last place.
void describe_odd_point(literate::Document& document, const parameters::HalfSpaceCase& c,
                        const config::UnitSystem& units, const PrintedData& printed_data,
                        std::size_t i) {
  const PrintedNumber& printed = printed_data.tri_dist.displacement[i];
  const std::string& unit = units.length;
  const double x = c.points[i];
  const numerics::Estimate exact = displacement(c, x);
  const numerics::Estimate slope = gradient(c, x);
  // The print is meant as it stands, not as the interval of what rounds to it.
  const double difference = std::abs(printed.value() - exact.value);
  document.value("tri-dist.odd.x", Value(x, fixed(decimals_of(c.points)), unit));
  document.value("tri-dist.odd.printed",
                 Value(printed.value(), scientific(printed.n_digits()), unit));
  document.value("tri-dist.odd.exact", Value(exact, scientific(printed.n_digits()), unit));
  document.value("tri-dist.odd.difference",
                 Value(numerics::Estimate{difference, exact.abs_error}, scientific(2), unit));
  document.value("tri-dist.odd.slope", Value(slope, scientific(3)));
}

// How far a number is from one that is printed, which it must round to.
Criterion from_print(const PrintedNumber& printed, Estimate computed) {
  const double distance = std::abs(computed.value - printed.value());
  return Criterion::at_most(
      "distance",
      Value(1 / printed.last_place() * Estimate{distance, computed.abs_error}, significant(2)),
      {LimitKind::printed, 0.5, "every printed digit: what is computed rounds to the print"});
}

Criterion rounds_to_print(const std::string& what, const std::vector<Criterion>& points) {
  return Criterion::in_each(what + " less the print, in units of the print's last place", "points",
                            points);
}

// What the listed program's output says of the load, and of the program.
void claim_tri_dist(literate::Document& document, const parameters::HalfSpaceCase& c,
                    const config::UnitSystem& units, const PrintedData& printed_data,
                    const std::vector<Criterion>& exact, const std::vector<Criterion>& stepped) {
  const PrintedNumber& first = printed_data.tri_dist.displacement.front();
  const Estimate load =
      c.load.line_load() * quotient(as_estimate(first), displacement(c, c.points.front()));
  const Estimate peak =
      c.load.peak_pressure() * quotient(as_estimate(first), displacement(c, c.points.front()));
  const Value in_words = Value(1000, literate::exact(), units.line_load).within(0);
  const Limit apart(
      LimitKind::convention, 1e-2,
      "far more than the digits of the print leave open, far less than other readings differ");
  document.claim(
      "load-in-words",
      {.route = "the first printed displacement over that of eq. (3) under unit load; a load on an "
                "edge is a force per length of edge, and so is a pressure times the unit thickness "
                "of a plane model",
       .expected = Verdict::partly,
       .criteria = {Criterion::agrees_relatively("as the peak p₀ of the load, on unit thickness",
                                                 Value(peak, significant(4), units.line_load),
                                                 in_words, apart),
                    Criterion::agrees_relatively("as the whole load P",
                                                 Value(load, significant(4), units.line_load),
                                                 in_words, apart)}});
  document.claim("tri-dist-is-equation-3",
                 {.route = "eq. (3) in this report's form, with the limits taken as limits",
                  .expected = Verdict::partly,
                  .criteria = {rounds_to_print("eq. (3)", exact)}});
  document.claim("tri-dist-steps-off",
                 {.route = "eq. (3) at the abscissae that the listing assigns",
                  .expected = Verdict::confirmed,
                  .criteria = {rounds_to_print("eq. (3) there", stepped)}});
}

// The program's output beside eq. (3), at the point and where the program really took it.
void compare_tri_dist(literate::Document& document, const parameters::HalfSpaceCase& c,
                      const config::UnitSystem& units, const PrintedData& printed_data) {
  const PrintedTriDist& printed = printed_data.tri_dist;
  const auto column = [&](const char* heading) {
    return Column(heading, fixed(7), units.length).scaled(-6);
  };
  literate::Table table(
      "tri-dist",
      {Column("$x$", fixed(decimals_of(c.points)), units.length).exact(), column("Tri\\_dist.m"),
       column("eq.~(3)"), Column("digits that agree", integer()), column("eq.~(3), stepped off")});
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
    const double stepped = analytical(c, stepped_x);
    const PrintedNumber& digits = printed.displacement[i];
    table.add_row({x, quoted(digits), displacement(c, x), digits.n_agreeing_digits(exact),
                   displacement(c, stepped_x)});
    at_point.push_back(from_print(digits, displacement(c, x)));
    at_step.push_back(
        from_print(digits, displacement(c, steps_off ? x + printed.step.value() : x)));
    n_agree += digits.agrees_with(exact);
    n_agree_stepped += digits.agrees_with(stepped);
    const double off = std::abs(digits.value() - exact) / digits.last_place();
    if (off > largest_off) {
      largest_off = off;
      odd = i;
    }
  }
  describe_odd_point(document, c, units, printed_data, odd);
  claim_tri_dist(document, c, units, printed_data, at_point, at_step);
  document.table(table);
  document.value("tri-dist.n-agree", Value(n_agree, integer()));
  document.value("tri-dist.n-agree-stepped", Value(n_agree_stepped, integer()));
  document.value("tri-dist.step", Value(printed.step.value(), exact(), units.length));
  document.value("tri-dist.n-digits", Value(printed.displacement.front().n_digits(), integer()));
}

// The columns of Fig. 5 against eq. (3), each other and Appendix 2.
void claim_figure5(literate::Document& document, const config::UnitSystem& units,
                   const PrintedData& printed_data, const std::vector<Criterion>& analytical,
                   const std::vector<Criterion>& errors_of_z) {
  const PrintedFigure5& printed = printed_data.figure5;
  const auto& measures = printed_data.appendix2.measures;
  document.claim("figure5-analytical", {.route = "eq. (3) with its limits",
                                        .expected = Verdict::partly,
                                        .criteria = {rounds_to_print("eq. (3)", analytical)}});
  document.claim(
      "error-of-z",
      {.route = "the difference of the printed columns, analytical less FEA (z)",
       .expected = Verdict::refuted,
       .criteria = {Criterion::in_each("that difference less the printed error, in units of the "
                                       "columns' last place",
                                       "points", errors_of_z)}});
  std::vector<Criterion> same;
  for (std::size_t i = 0; i < printed.fea_z.size(); ++i) {
    const PrintedNumber& measure = measures.at(fmt::format("measure{}", i + 1));
    const PrintedNumber& column = printed.fea_z[i];
    const double unit = std::min(column.last_place(), measure.last_place());
    const double apart = std::round(std::abs(column.value() + measure.value()) / unit);
    same.push_back(Criterion::at_most("difference", Value(apart, fixed(0)).within(0),
                                      {LimitKind::printed, 0.0, "the same digits"}));
  }
  document.claim(
      "fea-z-are-measures",
      {.route = "the column FEA (z) against measure1 to measure11 of the run's summary",
       .expected = Verdict::confirmed,
       .criteria = {Criterion::in_each("difference in units of the last place", "points", same)}});
  const PrintedNumber& maximum = measures.at("max_disp_mag");
  const PrintedNumber& largest = *std::ranges::max_element(
      printed.fea_magnitude, {}, [](const PrintedNumber& number) { return number.value(); });
  document.claim("largest-magnitude",
                 {.route = "the magnitudes that Fig. 5 prints from the same run",
                  .expected = Verdict::refuted,
                  .criteria = {Criterion::at_most(
                      "largest of the magnitudes in Fig. 5",
                      quoted_value(largest, units.length).within(largest.last_place() / 2),
                      {LimitKind::printed, as_estimate(maximum),
                       "max_disp_mag; both are known to half a unit of their last place",
                       maximum.n_digits()})}});
}

// Decimal fractions as doubles, in units of the last of seven places.
constexpr double rounding_of_print = 1e-8;

long n_holding(const std::vector<Criterion>& criteria) {
  return std::ranges::count(criteria, literate::Outcome::holds, &Criterion::outcome);
}

// Fig. 5 rebuilt: the analytical column from eq. (3), the error column from the other columns.
void compare_figure5(literate::Document& document, const parameters::HalfSpaceCase& c,
                     const config::UnitSystem& units, const PrintedData& printed_data) {
  const PrintedFigure5& printed = printed_data.figure5;
  const std::string& unit = units.length;
  const auto column = [&](const char* heading, int exponent) {
    return Column(heading, fixed(6), unit).scaled(exponent);
  };
  literate::Table table("figure5",
                        {Column("$x$", fixed(decimals_of(c.points)), unit), column("FEA ($z$)", -6),
                         column("analytical", -6), column("eq.~(3)", -6), column("error", -8),
                         column("$|$eq.~(3) $-$ FEA ($z$)$|$", -8)});
  long n_analytical = 0;
  std::vector<Criterion> analytical_points, errors_of_magnitude, errors_of_z;
  for (std::size_t i = 0; i < c.points.size(); ++i) {
    const double exact = analytical(c, c.points[i]);
    const numerics::Estimate u_z = displacement(c, c.points[i]);
    table.add_row({quoted(printed.x[i]), quoted(printed.fea_z[i]), quoted(printed.analytical[i]),
                   u_z, quoted(printed.error[i]), magnitude(u_z - as_estimate(printed.fea_z[i]))});
    n_analytical += printed.analytical[i].agrees_with(exact);
    analytical_points.push_back(from_print(printed.analytical[i], displacement(c, c.points[i])));

    // The error column is the difference of two printed columns: of which? It carries more digits
    // than they do, so it may be off by their last places.
    const double unit_of_place = printed.analytical[i].last_place();
    const auto explains = [&](const PrintedNumber& fea) {
      const double difference = std::abs(printed.analytical[i].value() - fea.value());
      const double off = std::abs(difference - printed.error[i].value()) / unit_of_place;
      return Criterion::at_most("difference", Value({off, rounding_of_print}, significant(2)),
                                {LimitKind::printed, 1.0,
                                 "the error column has more digits than the columns, of which each "
                                 "is known to half a unit"});
    };
    errors_of_magnitude.push_back(explains(printed.fea_magnitude[i]));
    errors_of_z.push_back(explains(printed.fea_z[i]));
  }
  document.table(table);
  claim_figure5(document, units, printed_data, analytical_points, errors_of_z);
  document.value("figure5.n-analytical", Value(n_analytical, integer()));
  document.value("figure5.n-errors-of-magnitude", Value(n_holding(errors_of_magnitude), integer()));
  document.value("figure5.n-errors-of-z", Value(n_holding(errors_of_z), integer()));
  document.check(
      "figure5-error-column",
      {Criterion::in_each("analytical less magnitude less error, in units of the last place",
                          "points", errors_of_magnitude)},
      "the error column of Fig. 5 is the difference from the FEA magnitude everywhere");
}

}  // namespace

void compute_results(literate::Document& document, const parameters::HalfSpaceCase& c,
                     const config::UnitSystem& units,
                     const std::optional<PrintedData>& printed_data) {
  document.figure("displacement-comparison", comparison_figure(c, units, printed_data));
  claim_shape(document, c);
  if (printed_data) {
    compare_tri_dist(document, c, units, *printed_data);
    compare_figure5(document, c, units, *printed_data);
  } else {
    tabulate_displacements(document, c, units);
  }
}

}  // namespace paper
