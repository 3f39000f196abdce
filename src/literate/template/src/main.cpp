#include <cmath>
#include <numbers>
#include <vector>

#include "config/table.hpp"
#include "literate/main/main.hpp"
#include "pendulum.hpp"

namespace {

using literate::Column;
using literate::Criterion;
using literate::exact;
using literate::fixed;
using literate::integer;
using literate::LimitKind;
using literate::percent;
using literate::significant;
using literate::supported;
using literate::Value;

constexpr double degree = std::numbers::pi / 180;

struct Parameters {
  double angle;    // degrees
  double length;   // m
  double gravity;  // m/s²
};

Parameters read_case(const std::filesystem::path& file) {
  const config::Table table = config::Table::parse_file(file);
  const Parameters parameters{.angle = table.number("angle"),
                              .length = table.quantity("length", "m"),
                              .gravity = table.quantity("gravity", "m/s2")};
  table.reject_unknown_keys();
  if (!(parameters.angle > 0 && parameters.angle < 180)) {
    table.fail("angle", "the swing is between 0 and 180 degrees");
  }
  return parameters;
}

// A sum of two terms, to rounding.
numerics::Estimate by_series(double angle) {
  const double series = short_series(angle);
  return {series, 1e-15 * series};
}

void register_table(literate::Document& document) {
  literate::Table table("periods", {Column("$\\theta$", integer(), "°"),
                                    Column("integral", fixed(8)).under("$T/T_0$"),
                                    Column("$1 + \\theta^2/16$", fixed(8)).under("$T/T_0$")});
  for (const int angle : {10, 30, 60, 90}) {
    table.add_row({angle, relative_period(angle * degree), by_series(angle * degree)});
  }
  document.table(std::move(table));
}

void register_figure(literate::Document& document) {
  std::vector<double> angles, periods, series;
  for (int angle = 0; angle <= 120; angle += 5) {
    angles.push_back(angle);
    periods.push_back(relative_period(angle * degree).value);
    series.push_back(short_series(angle * degree));
  }
  document.figure(
      "period",
      {.width_cm = 10,
       .height_cm = 6,
       .data = {{"periods", {{"angle", angles}, {"integral", periods}, {"series", series}}}}});
}

void register_claims(literate::Document& document, const Parameters& parameters) {
  const numerics::Estimate relative = relative_period(parameters.angle * degree);
  const numerics::Estimate excess = relative - numerics::Estimate{1, 0};
  document.claim("longer", {.route = "the integral for the period",
                            .expected = literate::Verdict::confirmed,
                            .criteria = {Criterion::at_least("excess", Value(excess, percent(1)),
                                                             {LimitKind::data, 0.1, "a tenth"})}});
  const Value series(by_series(parameters.angle * degree), significant(4));
  document.claim("series-suffices", {.route = "the same integral",
                                     .expected = literate::Verdict::refuted,
                                     .criteria = {Criterion::agrees_relatively(
                                         "series", series, Value(relative, significant(4)),
                                         {LimitKind::data, 0.01, "one part in a hundred"})}});
}

void compute(literate::Document& document, const literate::Inputs& inputs) {
  const Parameters parameters = read_case(inputs.case_file);
  const numerics::Estimate relative = relative_period(parameters.angle * degree);
  const double small = 2 * std::numbers::pi * std::sqrt(parameters.length / parameters.gravity);
  document.value("angle", Value(parameters.angle, exact(), "°"));
  document.value("length", Value(parameters.length, exact(), "m"));
  document.value("relative-period", Value(relative, supported()));
  document.value("period", Value(small * relative, significant(6), "s"));
  document.flag("is-wide", parameters.angle > 60);
  document.check(
      "longer-than-small",
      {Criterion::at_least("period over that of small swings", Value(relative, significant(4)),
                           {LimitKind::data, 1.0, "as long"})},
      "Far swings take longer than small ones.");
  register_table(document);
  register_figure(document);
  register_claims(document, parameters);
}

}  // namespace

int main(int argc, char** argv) {
  return literate::main(argc, argv, literate::this_paper(), compute);
}
