// SPDX-License-Identifier: GPL-3.0-or-later
// A whole small paper: how much longer a pendulum takes when it swings far.
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <numbers>
#include <vector>

#include "literate/document/document.hpp"
#include "literate/figures/draw.hpp"
#include "literate/prose/references.hpp"
#include "literate/typesetting/typeset.hpp"
#include "numerics/quadrature.hpp"

namespace {

using literate::Column;
using literate::Value;

constexpr double degree = std::numbers::pi / 180;

// begin excerpt: period
// T/T₀ = (2/π) ∫₀^{π/2} dφ/√(1 − sin²(θ/2) sin²φ), θ the greatest angle.
numerics::Estimate relative_period(double angle) {
  const double k = std::sin(angle / 2);
  const auto integrand = [k](double phi) {
    const double s = k * std::sin(phi);
    return 2 / std::numbers::pi / std::sqrt(1 - s * s);
  };
  numerics::Quadrature quadrature;
  return quadrature.adaptive(integrand, 0, std::numbers::pi / 2, 1e-13, {"period", angle});
}
// end excerpt: period

double short_series(double angle) {
  return 1 + angle * angle / 16;
}

void compute(literate::Document& document) {
  literate::Table table({Column::integer("$\\theta$", "°"), Column::fixed("$T/T_0$", "", 8),
                         Column::fixed("$1 + \\theta^2/16$", "", 8)});
  for (const int angle : {10, 30, 60, 90}) {
    table.add_row({angle, relative_period(angle * degree).value, short_series(angle * degree)});
  }
  document.table("periods", std::move(table));

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

  const numerics::Estimate quarter_turn = relative_period(90 * degree);
  document.value("period-at-90", Value::estimate(quarter_turn));
  document.claim("longer-at-90",
                 {.sentence = "From 90 degrees a pendulum takes 18 % longer.",
                  .place = "folklore",
                  .stated = Value::percent(0.18, 0),
                  .computed = Value::percent(quarter_turn.value - 1, 1),
                  .route = "the integral for the period, by quadrature",
                  .tolerance = "half a per cent, as the statement has no decimals",
                  .expected = literate::Verdict::confirmed,
                  .found = literate::confirmed_if(std::abs(quarter_turn.value - 1.18) < 0.005)});
  const double off = short_series(90 * degree) / quarter_turn.value - 1;
  document.claim("series-suffices",
                 {.sentence = "One term of the series is enough for 1 % up to 90 degrees.",
                  .place = "folklore",
                  .stated = Value::percent(0.01, 0),
                  .computed = Value::percent(std::abs(off), 1),
                  .route = "the same integral",
                  .tolerance = "none: the statement is a bound",
                  .expected = literate::Verdict::refuted,
                  .found = literate::confirmed_if(std::abs(off) <= 0.01)});
}

}  // namespace

// pendulum SOURCE OUTPUT: writes OUTPUT/pendulum.pdf from SOURCE/tests/literate/example.
int main(int argc, char** argv) {
  if (argc != 3) {
    std::fputs("usage: pendulum CHECKOUT OUTPUT\n", stderr);
    return 2;
  }
  try {
    const std::filesystem::path checkout = argv[1];
    const std::filesystem::path output = argv[2];
    literate::Document document;
    compute(document);
    const std::filesystem::path paper = checkout / "tests/literate/example";
    document.write(output / "generated",
                   literate::find_excerpts(checkout, {"tests/literate/example"}));
    literate::draw_figures(output / "generated", paper / "figures", document.figure_places());
    literate::typeset({.source_dir = paper,
                       .main_file = "pendulum.tex",
                       .generated_dir = output / "generated",
                       .build_dir = output / "latex",
                       .output_pdf = output / "pendulum.pdf"});
    for (const std::string& fault : document.faults()) std::fprintf(stderr, "%s\n", fault.c_str());
    return document.faults().empty() ? 0 : 1;
  } catch (const std::exception& e) {
    std::fprintf(stderr, "pendulum: %s\n", e.what());
    return 3;
  }
}
