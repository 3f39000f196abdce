#include "literate/main/main.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "config/table.hpp"

namespace {

using literate::Column;
using literate::Criterion;
using literate::exact;
using literate::fixed;
using literate::integer;
using literate::LimitKind;
using literate::percent;
using literate::significant;
using literate::Value;
using literate::Verdict;
using numerics::Estimate;

constexpr double degree = std::numbers::pi / 180;

struct Parameters {
  double angle;    // degrees
  double length;   // m
  double gravity;  // m/s²
};

Parameters read_case(const std::filesystem::path& file) {
  const config::Table table = config::Table::parse_file(file);
  const Parameters parameters{.angle = table.number("angle"),
                              .length = table.number("length"),
                              .gravity = table.number("gravity")};
  table.reject_unknown_keys();
  if (!(parameters.angle > 0 && parameters.angle < 180)) {
    table.fail("angle", "must be between 0 and 180 degrees");
  }
  return parameters;
}

// The integrand is periodic and smooth, so the trapezoidal rule converges faster than any power of
// its step.
double trapezoidal(double k, int n_intervals) {
  const double step = std::numbers::pi / 2 / n_intervals;
  double sum = 0.5 * (1 + 1 / std::sqrt(1 - k * k));
  for (int i = 1; i < n_intervals; ++i) {
    const double s = k * std::sin(i * step);
    sum += 1 / std::sqrt(1 - s * s);
  }
  return sum / n_intervals;
}

// The period of a pendulum with amplitude `angle` (radians, below π) over that of small swings:
// T/T₀ = (2/π) ∫₀^{π/2} dφ/√(1 − sin²(angle/2) sin²φ). Its error bound is the difference from half
// as many points plus rounding.
Estimate relative_period(double angle) {
  const double k = std::sin(angle / 2);
  const int n = 64;
  const double coarse = trapezoidal(k, n / 2);
  const double fine = trapezoidal(k, n);
  // Each of the n terms is accurate to a few ε, and so is their mean.
  const double rounding = 8 * std::numeric_limits<double>::epsilon() * fine;
  return {fine, std::abs(fine - coarse) + rounding};
}

// The first two terms of its series in the angle.
double short_series(double angle) {
  return 1 + angle * angle / 16;
}

// The sum of two terms, with a bound on its rounding error.
Estimate by_series(double angle) {
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

void register_claims(literate::Document& document, double angle) {
  const Estimate relative = relative_period(angle);
  const Estimate excess{relative.value - 1, relative.abs_error};
  document.check(
      "longer-than-small",
      {Criterion::at_least("period over that of small swings", Value(relative, significant(4)),
                           {1, LimitKind::theory, "as long"})},
      "Far swings take longer than small ones.");
  document.claim("longer", {.route = "the integral for the period",
                            .expected = Verdict::holds,
                            .criteria = {Criterion::at_least("excess", Value(excess, percent(1)),
                                                             {0.1, LimitKind::data, "a tenth"})}});
  document.claim("series-suffices", {.route = "the same integral",
                                     .expected = Verdict::fails,
                                     .criteria = {Criterion::agrees_relatively(
                                         "series", Value(by_series(angle), significant(4)),
                                         Value(relative, significant(4)),
                                         {0.01, LimitKind::data, "one part in a hundred"})}});
}

/// Registers everything that the paper prints.
void compute(literate::Document& document, const std::filesystem::path& case_file) {
  const Parameters parameters = read_case(case_file);
  const Estimate relative = relative_period(parameters.angle * degree);
  const double small = 2 * std::numbers::pi * std::sqrt(parameters.length / parameters.gravity);
  document.value("angle", Value(parameters.angle, exact(), "°"));
  document.value("length", Value(parameters.length, exact(), "m"));
  document.value("relative-period", Value(relative, significant(6)));
  document.value("period", Value(Estimate{small * relative.value, small * relative.abs_error},
                                 significant(6), "s"));
  document.flag("is-wide", parameters.angle > 60);
  register_table(document);
  register_figure(document);
  register_claims(document, parameters.angle * degree);
}

}  // namespace

int main(int argc, char** argv) {
  return literate::main(argc, argv, compute);
}
