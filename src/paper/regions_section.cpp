// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "contact/approach_control.hpp"
#include "contact/fft_solver.hpp"
#include "contact/hertz.hpp"
#include "literate/document/document.hpp"
#include "paper/bounds.hpp"
#include "parameters/case.hpp"

namespace paper {
namespace {

using contact::Hertz;
using contact::Problem;
using contact::Profile;
using contact::Solution;
using Eigen::Index;
using literate::Cell;
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
using parameters::ContactCase;

// The cylinders with waves on them: h = x²/(2R) + Δ[1 − cos(2πx/λ)], given by points.
struct WavyCylinders {
  double length;               // λ
  double amplitude;            // Δ
  double flattening_pressure;  // p* = πE*Δ/λ, which presses endless waves flat (Johnson 13.2)
  Problem problem;
};

constexpr double waves_in_half_width = 3;
constexpr double flattening_share = 0.8;  // p*/p₀
constexpr int n_sampled = 2001;
constexpr Index n_wavy_nodes = 600;
constexpr double domain = 3;  // over a

WavyCylinders wavy_cylinders(const ContactCase& c, const Hertz& hertz) {
  const double a = hertz.half_width();
  const double modulus = c.cylinders.contact_modulus();
  const double length = a / waves_in_half_width;
  const double flattening = flattening_share * hertz.peak_pressure();
  const double amplitude = flattening * length / (std::numbers::pi * modulus);
  const Profile smooth = c.cylinders.profile();
  std::vector<double> x, gap;
  for (int i = 0; i < n_sampled; ++i) {
    x.push_back(2 * a * (2.0 * i / (n_sampled - 1) - 1));
    const double rise = std::pow(std::sin(std::numbers::pi * x.back() / length), 2);
    gap.push_back(smooth.gap(x.back()) + 2 * amplitude * rise);
  }
  return {length,
          amplitude,
          flattening,
          {Profile::tabulated(x, gap), modulus, contact::grid_of_width(domain * a, n_wavy_nodes)}};
}

// Valleys lie midway between crests; one is closed if a region of contact spans it.
int closed_valleys(const WavyCylinders& wavy, const Solution& solution) {
  int n = 0;
  for (int k = -10; k < 10; ++k) {
    const double x = (k + 0.5) * wavy.length;
    n += std::ranges::any_of(solution.regions(), [x](const contact::Region& region) {
      return region.begin < x && x < region.end;
    });
  }
  return n;
}

// Those where the pressure of smooth cylinders is above p*.
int valleys_expected_closed(const WavyCylinders& wavy, const Hertz& smooth) {
  int n = 0;
  for (int k = -10; k < 10; ++k) {
    n += smooth.pressure((k + 0.5) * wavy.length) > wavy.flattening_pressure;
  }
  return n;
}

// The pressure over p₀ and against x/a of smooth cylinders, and theirs under the same load.
literate::FigureData panel_of(const Solution& solution, const Hertz& smooth, const Hertz& hertz) {
  std::vector<double> node_x, pressure, smooth_pressure;
  for (Index i = 0; i < solution.grid.n_nodes; ++i) {
    const double x = solution.grid.x(i);
    node_x.push_back(x / hertz.half_width());
    pressure.push_back(solution.pressure[i] / hertz.peak_pressure());
    smooth_pressure.push_back(smooth.pressure(x) / hertz.peak_pressure());
  }
  return {{"x", node_x}, {"pressure", pressure}, {"smooth", smooth_pressure}};
}

struct Loading {
  std::string name;
  double share;  // of P
  bool is_drawn;
};

const std::array<Loading, 7> loadings = {{{"$P/64$", 1. / 64, false},
                                          {"$P/16$", 1. / 16, false},
                                          {"$P/4$", 1. / 4, true},
                                          {"$P/2$", 1. / 2, true},
                                          {"$3P/4$", 3. / 4, false},
                                          {"$P$", 1, true},
                                          {"$3P/2$", 3. / 2, false}}};

void register_regions(literate::Document& document, const ContactCase& c, const Hertz& hertz,
                      const WavyCylinders& wavy) {
  literate::Table table(
      "several-regions",
      {Column::text("load"), Column("regions", integer()),
       Column("closed", integer()).under("valleys"), Column("expected", integer()).under("valleys"),
       Column("outermost edge$/a$", fixed(2)), Column("share in contact", fixed(2))});
  literate::Figure figure{.width_cm = 14, .height_cm = 8.6};
  int n_panels = 0;
  std::vector<std::size_t> counts;
  std::vector<Criterion> loads_with_valleys_as_expected;
  long n_closed = 0;
  for (const Loading& loading : loadings) {
    const double load = loading.share * c.line_load;
    const Solution solution = contact::solve_by_fft(wavy.problem, load);
    const Hertz smooth(c.cylinders, load);
    const std::vector<contact::Region> regions = solution.regions();
    double touching = 0;
    for (const contact::Region& region : regions) touching += region.end - region.begin;
    const double extent = regions.back().end - regions.front().begin;
    const int closed = closed_valleys(wavy, solution);
    const int expected = valleys_expected_closed(wavy, smooth);
    counts.push_back(regions.size());
    loads_with_valleys_as_expected.push_back(Criterion::agrees(
        "difference", Value(closed - expected, integer()).within(0), Value(0, integer()).within(0),
        {LimitKind::derived, 0.0, "it is a count"}));
    n_closed += closed;
    // Every edge is wrong by so much, with either sign.
    const double of_edge = edge_error(solution);
    const double of_touching = 2 * static_cast<double>(regions.size()) * of_edge;
    table.add_row({Cell::latex(loading.name), counts.back(), closed, expected,
                   Estimate{regions.back().end / hertz.half_width(),
                            of_edge / hertz.half_width() + rounded(c, 1)},
                   quotient({touching, of_touching}, {extent, 2 * of_edge})});
    if (loading.is_drawn) {
      ++n_panels;
      figure.data[fmt::format("panel_{}", n_panels)] = panel_of(solution, smooth, hertz);
      figure.texts[fmt::format("title_{}", n_panels)] = loading.name;
    }
  }
  document.table(std::move(table));
  figure.numbers["n_panels"] = n_panels;
  document.figure("several-regions", std::move(figure));
  const std::size_t most = std::ranges::max(counts);
  document.value("wavy.most-regions", Value(static_cast<long>(most), integer()));
  document.claim(
      "valleys-close",
      {.route = "seven loads on wavy cylinders, given as a measured profile",
       .expected = Verdict::confirmed,
       .criteria = {Criterion::in_each("valleys closed, more or less than expected", "loads",
                                       loads_with_valleys_as_expected),
                    Criterion::at_least(
                        "valleys closed in all", Value(n_closed, integer()).within(0),
                        {LimitKind::convention, 1.0, "without one nothing would be tried"})}});
  const auto count = [](const char* what, std::size_t found, std::size_t asked,
                        const char* reason) {
    return Criterion::agrees(what, Value(static_cast<long>(found), integer()).within(0),
                             Value(static_cast<long>(asked), integer()).within(0),
                             {LimitKind::regression, 0.0, reason});
  };
  document.check("regions-form-and-join",
                 {count("regions under the lightest load", counts.front(), 1, "the middle crest"),
                  count("regions at most", most, 5, "the crests of three waves a half-width"),
                  Criterion::at_most(
                      "regions under the heaviest load",
                      Value(static_cast<long>(counts.back()), integer()).within(0),
                      {LimitKind::stated, static_cast<double>(most - 1), "fewer than at most"})},
                 "regions appear, and join, as the load grows");
}

// The approach with its error of discretisation: that of elements a quarter as wide, on the same
// profile, is a sixteenth, so that twice the difference is a bound.
Estimate refined_approach(const Solution& solution, const ContactCase& c, Problem problem,
                          double domain_width) {
  problem.grid = contact::grid_of_width(domain_width, 4 * problem.grid.n_nodes);
  const double finer = contact::solve_by_fft(problem, solution.line_load()).approach(c.datum);
  const double approach = solution.approach(c.datum);
  return {approach, 2 * std::abs(approach - finer) + rounded(c, approach)};
}

// Load → approach → load.
void register_round_trip(literate::Document& document, const ContactCase& c, const Hertz& hertz,
                         const WavyCylinders& wavy, const config::UnitSystem& units) {
  const auto method = [](const Problem& problem, double load) {
    constexpr double tolerance = 1e-12;
    return contact::solve_by_fft(problem, load, tolerance);
  };
  const Solution solution = method(wavy.problem, c.line_load / 2);
  const double approach = solution.approach(c.datum);
  const Solution again = contact::solve_for_approach(wavy.problem, approach, c.datum, method);
  const double difference = std::abs(again.line_load() / solution.line_load() - 1);
  document.value("wavy.approach",
                 Value(refined_approach(solution, c, wavy.problem, domain * hertz.half_width()),
                       significant(4), units.length));
  document.value("wavy.round-trip", Value(difference, scientific(1).rounded_up()));
  document.check(
      "approach-gives-the-load-back",
      {Criterion::at_most(
           "relative difference of the loads",
           Value(difference, scientific(1).rounded_up()).within(0),
           {LimitKind::rounding, 1e-11, "the tolerance of both solutions, and more"}),
       Criterion::agrees("nodes in contact", Value(again.n_in_contact(), integer()).within(0),
                         Value(solution.n_in_contact(), integer()).within(0),
                         {LimitKind::stated, 0.0, "the same nodes"})},
      "the approach that a load makes gives the same load back");
}

}  // namespace

void compute_regions(literate::Document& document, const parameters::ContactCase& c,
                     const config::UnitSystem& units) {
  const Hertz hertz(c.cylinders, c.line_load);
  const WavyCylinders wavy = wavy_cylinders(c, hertz);
  const std::string& unit = units.length;
  document.value("wavy.amplitude",
                 Value(wavy.amplitude, significant(3), unit).within(rounded(c, wavy.amplitude)));
  document.value("wavy.length",
                 Value(wavy.length, significant(3), unit).within(rounded(c, wavy.length)));
  document.value("wavy.waves", Value(waves_in_half_width, exact()));
  document.value("wavy.flattening-share", Value(flattening_share, fixed(1)));
  document.value("wavy.points", Value(n_sampled, integer()));
  register_regions(document, c, hertz, wavy);
  register_round_trip(document, c, hertz, wavy, units);
}

}  // namespace paper
