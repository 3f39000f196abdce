// SPDX-License-Identifier: GPL-3.0-or-later
// A whole small paper: how much longer the period of a pendulum is at large swings.
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "config/table.hpp"
#include "literate/main/main.hpp"

namespace {

using literate::Cell;
using literate::Column;
using literate::Criterion;
using literate::exact;
using literate::fixed;
using literate::integer;
using literate::LimitKind;
using literate::percent;
using literate::scientific;
using literate::significant;
using literate::uncertain;
using literate::Value;
using numerics::Estimate;

constexpr double degree = std::numbers::pi / 180;

struct Parameters {
  int angle;       // degrees
  double length;   // m
  double gravity;  // m/s²
};

Parameters read_case(const std::filesystem::path& file) {
  const config::Table table = config::Table::parse_file(file);
  const Parameters parameters{.angle = static_cast<int>(table.integer("angle")),
                              .length = table.quantity("length", "m"),
                              .gravity = table.quantity("gravity", "m/s2")};
  table.reject_unknown_keys();
  return parameters;
}

// The period over that of small swings, 1/agm(1, cos θ/2): the arithmetic-geometric mean doubles
// its digits with each step. It needs only the square of the cosine, which is exact for the angles
// here, so that every machine computes the same.
Estimate relative_period(double square_of_cosine) {
  constexpr int n_steps = 6;
  double a = 1, b = std::sqrt(square_of_cosine);
  for (int i = 0; i < n_steps; ++i) {
    const double mean = (a + b) / 2;
    b = std::sqrt(a * b);
    a = mean;
  }
  const double rounding = 2 * n_steps * std::numeric_limits<double>::epsilon();
  return {1 / a, std::abs(1 / a - 1 / b) + rounding / a};
}

Estimate excess_of(Estimate period) {
  return {period.value - 1, period.abs_error};
}

/// cos²(θ/2) for θ = 0°, 60°, 90°, 120°.
double square_of_cosine(int angle) {
  return angle == 0 ? 1 : angle == 60 ? 0.75 : angle == 90 ? 0.5 : 0.25;
}

Estimate short_series(double angle) {
  const double series = 1 + angle * degree * angle * degree / 16;
  return {series, 1e-15 * series};
}

void register_table(literate::Document& document) {
  literate::Table table("periods", {Column("$\\theta$", integer(), "degree"),
                                    Column("integral", fixed(8)).under("$T/T_0$"),
                                    Column("$1+\\theta^2/16$", fixed(8)).under("$T/T_0$"),
                                    Column("excess in %", percent(2)), Column::text("swing")});
  for (const int angle : {0, 60, 90, 120}) {
    const Estimate period = relative_period(square_of_cosine(angle));
    table.add_row({angle, period, short_series(angle), excess_of(period),
                   angle < 90 ? Cell("[small]") : Cell::latex("$\\ge90^{\\circ}$")});
  }
  table.note("The series has two terms.");
  document.table(std::move(table));
}

void register_figure(literate::Document& document) {
  std::vector<double> angles, periods, series;
  for (const int angle : {0, 60, 90, 120}) {
    angles.push_back(angle);
    periods.push_back(relative_period(square_of_cosine(angle)).value);
    series.push_back(angle == 90 ? literate::gap : short_series(angle).value);
  }
  document.figure(
      "period",
      {.width_cm = 10,
       .height_cm = 6,
       .data = {{"periods", {{"angle", angles}, {"integral", periods}, {"series", series}}}},
       .numbers = {{"largest", 120}},
       .texts = {{"heading", "$T/T_0$, 'exact'"}}});
}

void register_claims(literate::Document& document, int angle) {
  const Estimate relative = relative_period(square_of_cosine(angle));
  document.check(
      "longer-than-small",
      {Criterion::at_least("period over that of small swings", Value(relative, significant(4)),
                           {1, LimitKind::theory, "as long"})},
      "Far swings take longer than small ones.");
  document.claim("longer",
                 {.route = "the integral for the period",
                  .expected = literate::Verdict::holds,
                  .criteria = {Criterion::at_least("excess", Value(excess_of(relative), percent(1)),
                                                   {0.1, LimitKind::data, "a tenth"})}});
  document.claim("series-suffices", {.route = "the same integral",
                                     .expected = literate::Verdict::fails,
                                     .criteria = {Criterion::agrees_relatively(
                                         "series", Value(short_series(angle), significant(4)),
                                         Value(relative, significant(4)),
                                         {0.01, LimitKind::choice, "one part in a hundred"})}});
}

void compute(literate::Document& document, const std::filesystem::path& case_file) {
  const Parameters parameters = read_case(case_file);
  const double small = 2 * std::numbers::pi * std::sqrt(parameters.length / parameters.gravity);
  document.value("angle", Value(parameters.angle, integer(), "degree"));
  document.value("length", Value(parameters.length, exact(), "m"));
  document.value("gravity", Value(parameters.gravity, exact(), "m/s2"));
  if (parameters.angle < 0) throw std::runtime_error("no swing");
  const Estimate relative = relative_period(square_of_cosine(parameters.angle));
  document.value("relative-period", Value(relative, significant(7)));
  document.value("period", Value(Estimate{small * relative.value, small * relative.abs_error},
                                 significant(4), "s"));
  document.value("measured", Value({2.37, 0.002, 0.014}, uncertain(), "s"));
  document.value("rounding", Value(3.2e-16, scientific(1).rounded_up()).as_is());
  document.value("who", Value::text("Huygens & sons, 100 %"));
  document.flag("is-wide", parameters.angle > 60);
  register_table(document);
  register_figure(document);
  register_claims(document, parameters.angle);
}

}  // namespace

int main(int argc, char** argv) {
  return literate::main(argc, argv, compute);
}
