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
using literate::confirmed_if;
using literate::exact;
using literate::fixed;
using literate::integer;
using literate::percent;
using literate::scientific;
using literate::significant;
using literate::Value;
using literate::Verdict;

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
void claim_shape(literate::Document& document, const parameters::HalfSpaceCase& c,
                 const std::optional<PrintedData>& printed_data) {
  const elasticity::SurfaceQuadrature surface(c.material, c.load, c.datum);
  const double unit = c.material.integral_compliance() * c.load.line_load();
  double largest = 0;
  bool is_symmetric = true;
  for (const double x : c.points) {
    const numerics::Estimate difference =
        surface.normal_displacement(x) - surface.normal_displacement(-x);
    largest = std::max(largest, std::abs(difference.value));
    is_symmetric = is_symmetric && std::abs(difference.value) <= difference.abs_error;
  }
  document.claim("symmetric",
                 {.sentence = "The displacements are symmetrical about x = 0.",
                  .place = "paper, Results, p. 8",
                  .computed = Value(largest / unit, scientific(1).rounded_up()),
                  .route = "eq. (2) by quadrature at x and at −x, where nothing is known of the "
                           "symmetry; the value is the largest difference over K",
                  .tolerance = "the errors that the two quadratures report",
                  .expected = Verdict::confirmed,
                  .found = confirmed_if(is_symmetric)});
  if (!printed_data) return;
  const double end = c.farthest_point();
  const numerics::Estimate share =
      quotient(surface.normal_displacement(end), surface.normal_displacement(0));
  document.claim(
      "deflects-far-away",
      {.sentence = "The triangular load deflects the surface at distances well outside "
                   "the loaded region.",
       .place = "paper, Conclusions, p. 9",
       .computed = Value(share, percent(0)),
       .route = "eq. (2) by quadrature at the last point, as a share of the middle",
       .tolerance = "at least a tenth, less than which would hardly be seen in its Fig. 4",
       .expected = Verdict::confirmed,
       .found = confirmed_if(end > 2 * c.load.half_width() && share.value > 0.1)});
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

// What the listed program's output says of the load, and of the program.
void claim_tri_dist(literate::Document& document, const parameters::HalfSpaceCase& c,
                    const config::UnitSystem& units, const PrintedData& printed_data, long n_agree,
                    long n_stepped) {
  const PrintedNumber& first = printed_data.tri_dist.displacement.front();
  const long n = std::ssize(c.points);
  const numerics::Estimate load =
      c.load.line_load() * quotient(as_estimate(first), displacement(c, c.points.front()));
  constexpr double in_words = 1000;
  document.claim("load-in-words",
                 {.sentence = "A 1000 pound/inch load is applied.",
                  .place = "paper, Numerical Solution, p. 6; Appendix 1, p. 12",
                  .stated = Value(in_words, exact(), units.line_load),
                  .computed = Value(load, significant(4), units.line_load),
                  .route = "the first printed displacement over that of eq. (3) under unit load",
                  .tolerance = "1 %, where the print and eq. (3) have eight digits",
                  .expected = Verdict::refuted,
                  .found = confirmed_if(std::abs(load.value / in_words - 1) < 1e-2)});
  const auto of_points = [n](long count) {
    return Value::text(fmt::format("{} of {} points", count, n));
  };
  document.claim("tri-dist-is-equation-3",
                 {.sentence = "The listed program, Tri_dist.m, computes eq. (3).",
                  .place = "paper, Appendix 1, p. 12",
                  .computed = of_points(n_agree),
                  .route = "eq. (3) in this report's form, with the limits taken as limits",
                  .tolerance = fmt::format("all {} printed digits: eq. (3) must round to the print",
                                           first.n_digits()),
                  .expected = Verdict::partly,
                  .found = literate::confirmed_in(n_agree, n)});
  document.claim("tri-dist-steps-off",
                 {.sentence = "Tri_dist.m is eq. (3) where it really evaluates it, a step off the "
                              "singular points.",
                  .place = "this report",
                  .computed = of_points(n_stepped),
                  .route = "eq. (3) at the abscissae that the listing assigns",
                  .tolerance = fmt::format("all {} printed digits: eq. (3) must round to the print",
                                           first.n_digits()),
                  .expected = Verdict::confirmed,
                  .found = literate::confirmed_in(n_stepped, n)});
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
    n_agree += digits.agrees_with(exact);
    n_agree_stepped += digits.agrees_with(stepped);
    const double off = std::abs(digits.value() - exact) / digits.last_place();
    if (off > largest_off) {
      largest_off = off;
      odd = i;
    }
  }
  describe_odd_point(document, c, units, printed_data, odd);
  claim_tri_dist(document, c, units, printed_data, n_agree, n_agree_stepped);
  const long n_points = std::ssize(c.points);
  document.table(table);
  document.value("tri-dist.n-agree", Value(n_agree, integer()));
  document.value("tri-dist.n-agree-stepped", Value(n_agree_stepped, integer()));
  document.value("tri-dist.step", Value(printed.step.value(), exact(), units.length));
  document.value("tri-dist.n-digits", Value(printed.displacement.front().n_digits(), integer()));
  document.check("tri-dist-digits", n_agree == n_points - 1,
                 "eq. (3) has every printed digit of Tri_dist.m at all points but one");
  document.check("tri-dist-step", n_agree_stepped == n_points,
                 "eq. (3) where Tri_dist.m really took it has every printed digit at all points");
}

// The columns of Fig. 5 against eq. (3), each other and Appendix 2.
void claim_figure5(literate::Document& document, const config::UnitSystem& units,
                   const PrintedData& printed_data, long n_analytical, long n_errors_of_z) {
  const PrintedFigure5& printed = printed_data.figure5;
  const auto& measures = printed_data.appendix2.measures;
  const long n = std::ssize(printed.x);
  const auto of_points = [n](long count) {
    return Value::text(fmt::format("{} of {} points", count, n));
  };
  const int n_digits = printed.analytical.front().n_digits();
  document.claim("figure5-analytical", {.sentence = "The analytical column of Fig. 5 is eq. (3).",
                                        .place = "paper, Error Analysis, Fig. 5, p. 9",
                                        .computed = of_points(n_analytical),
                                        .route = "eq. (3) with its limits",
                                        .tolerance = fmt::format("all {} printed digits", n_digits),
                                        .expected = Verdict::partly,
                                        .found = literate::confirmed_in(n_analytical, n)});
  document.claim(
      "error-of-z",
      {.sentence = "The error is calculated using displacements in the z-direction only.",
       .place = "paper, Error Analysis, p. 8",
       .computed = of_points(n_errors_of_z),
       .route = "the difference of the printed columns, analytical less FEA (z)",
       .tolerance = "one unit of the last place of these columns, which the error column "
                    "exceeds in digits",
       .expected = Verdict::refuted,
       .found = literate::confirmed_in(n_errors_of_z, n)});
  long n_same = 0;
  for (long i = 0; i < n; ++i) {
    const PrintedNumber& measure = measures.at(fmt::format("measure{}", i + 1));
    const PrintedNumber& column = printed.fea_z[static_cast<std::size_t>(i)];
    n_same += column.n_digits() == measure.n_digits() && column.agrees_with(-measure.value());
  }
  document.claim("fea-z-are-measures",
                 {.sentence = "Fig. 5 shows the values obtained from the finite-element run.",
                  .place = "paper, Error Analysis, p. 8; Appendix 2, pp. 15–16",
                  .computed = of_points(n_same),
                  .route = "the column FEA (z) against measure1 to measure11 of the run's summary",
                  .tolerance = "none: the same digits",
                  .expected = Verdict::confirmed,
                  .found = literate::confirmed_in(n_same, n)});
  const PrintedNumber& maximum = measures.at("max_disp_mag");
  const PrintedNumber& largest = *std::ranges::max_element(
      printed.fea_magnitude, {}, [](const PrintedNumber& number) { return number.value(); });
  document.claim(
      "largest-magnitude",
      {.sentence = "The largest displacement of the run is max_disp_mag.",
       .place = "paper, Appendix 2, p. 15",
       .stated = quoted_value(maximum, units.length),
       .computed = quoted_value(largest, units.length),
       .route = "the largest of the magnitudes that Fig. 5 prints from the same run",
       .tolerance = "half a unit of the last place: no magnitude may exceed the maximum",
       .expected = Verdict::refuted,
       .found = confirmed_if(largest.value() <= maximum.value() + maximum.last_place() / 2)});
}

// Its accuracy as the run states it, and that of the closed form as the program printed it.
void claim_accuracy(literate::Document& document, const parameters::HalfSpaceCase& c,
                    const PrintedData& printed_data) {
  double fea = HUGE_VAL;
  double closed_form = 0;
  for (std::size_t i = 0; i < c.points.size(); ++i) {
    const auto convergence =
        printed_data.appendix2.convergence.find(fmt::format("measure{}", i + 1));
    if (convergence != printed_data.appendix2.convergence.end()) {
      fea = std::min(fea, convergence->second.value() / 100);
    }
    const double exact = analytical(c, c.points[i]);
    closed_form =
        std::max(closed_form, std::abs(printed_data.tri_dist.displacement[i].value() / exact - 1));
  }
  document.claim(
      "fea-most-accurate",
      {.sentence = "FEA has the advantage of providing the most accurate results.",
       .place = "paper, Conclusions, p. 10",
       .stated = Value(fea, scientific(1)),
       .computed = Value(closed_form, scientific(1).rounded_up()),
       .route = "stated is the best convergence that the run reports for a displacement, "
                "computed the largest relative error of the printed closed form",
       .tolerance = "none: the smaller error is the more accurate",
       .expected = Verdict::refuted,
       .found = confirmed_if(fea <= closed_form)});
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
  long n_errors_of_magnitude = 0;
  long n_errors_of_z = 0;
  for (std::size_t i = 0; i < c.points.size(); ++i) {
    const double exact = analytical(c, c.points[i]);
    const numerics::Estimate u_z = displacement(c, c.points[i]);
    table.add_row({quoted(printed.x[i]), quoted(printed.fea_z[i]), quoted(printed.analytical[i]),
                   u_z, quoted(printed.error[i]), magnitude(u_z - as_estimate(printed.fea_z[i]))});
    n_analytical += printed.analytical[i].agrees_with(exact);

    // The error column is the difference of two printed columns: of which? It carries more digits
    // than they do, so it may be off by their last places.
    const double slack = printed.analytical[i].last_place();
    const auto explains = [&](const PrintedNumber& fea) {
      const double difference = std::abs(printed.analytical[i].value() - fea.value());
      return std::abs(difference - printed.error[i].value()) <= slack;
    };
    n_errors_of_magnitude += explains(printed.fea_magnitude[i]);
    n_errors_of_z += explains(printed.fea_z[i]);
  }
  document.table(table);
  claim_figure5(document, units, printed_data, n_analytical, n_errors_of_z);
  claim_accuracy(document, c, printed_data);
  document.value("figure5.n-analytical", Value(n_analytical, integer()));
  document.value("figure5.n-errors-of-magnitude", Value(n_errors_of_magnitude, integer()));
  document.value("figure5.n-errors-of-z", Value(n_errors_of_z, integer()));
  document.check("figure5-error-column", n_errors_of_magnitude == std::ssize(c.points),
                 "the error column of Fig. 5 is the difference from the FEA magnitude everywhere");
}

}  // namespace

void compute_results(literate::Document& document, const parameters::HalfSpaceCase& c,
                     const config::UnitSystem& units,
                     const std::optional<PrintedData>& printed_data) {
  document.figure("displacement-comparison", comparison_figure(c, units, printed_data));
  claim_shape(document, c, printed_data);
  if (printed_data) {
    compare_tri_dist(document, c, units, *printed_data);
    compare_figure5(document, c, units, *printed_data);
  } else {
    tabulate_displacements(document, c, units);
  }
}

}  // namespace paper
