// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "line_contact/solver.hpp"
#include "paper/bounds.hpp"
#include "paper/paper.hpp"

namespace paper {
namespace {

using Eigen::Index;
using line_contact::Problem;
using line_contact::Profile;
using line_contact::Solution;

// The cylinders with waves on them: h = x²/(2R) + Δ[1 − cos(2πx/λ)], given by points.
struct WavyCylinders {
  double length;               // λ
  double amplitude;            // Δ
  double flattening_pressure;  // p* = πE*Δ/λ, which presses endless waves flat (Johnson 13.2)
  Problem problem;
};

constexpr Index n_wavy_nodes = 600;
constexpr double domain = 3;  // over a

WavyCylinders wavy_cylinders(const ContactCase& c, const WavesCase& waves, const Hertz& hertz) {
  const double a = hertz.half_width();
  const double modulus = c.cylinders.contact_modulus();
  const double length = a / waves.in_half_width;
  const double flattening = waves.flattening_share * hertz.peak_pressure();
  const double amplitude = flattening * length / (std::numbers::pi * modulus);
  const Profile smooth = c.cylinders.profile();
  std::vector<double> x, gap;
  for (long i = 0; i < waves.n_points; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(waves.n_points - 1);
    x.push_back(2 * a * (2 * share - 1));
    const double rise = std::pow(std::sin(std::numbers::pi * x.back() / length), 2);
    gap.push_back(smooth.gap(x.back()) + 2 * amplitude * rise);
  }
  return {
      length,
      amplitude,
      flattening,
      {Profile::tabulated(x, gap), modulus, line_contact::grid_of_width(domain * a, n_wavy_nodes)}};
}

// Valleys lie midway between crests; one is closed if a region of contact spans it.
int closed_valleys(const WavyCylinders& wavy, const Solution& solution) {
  int n = 0;
  for (int k = -10; k < 10; ++k) {
    const double x = (k + 0.5) * wavy.length;
    n += std::ranges::any_of(solution.regions(), [x](const line_contact::Region& region) {
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

// The load under which the valley at x closes, over P, by bisection: what a grid of half the
// spacing finds, with how far the grid itself is from it.
Estimate closing_share(const ContactCase& c, const WavyCylinders& wavy, double x) {
  constexpr double tolerance = 1e-4;
  const auto found_on = [&](Index n_nodes) {
    Problem problem = wavy.problem;
    problem.grid =
        line_contact::grid_of_width(wavy.problem.grid.end() - wavy.problem.grid.begin(), n_nodes);
    double low = 0.1;
    double high = 1.5;
    while (high - low > tolerance) {
      const double share = (low + high) / 2;
      const auto regions = line_contact::solve_by_fft(problem, share * c.line_load).regions();
      const bool is_closed = std::ranges::any_of(
          regions, [x](const auto& region) { return region.begin < x && x < region.end; });
      (is_closed ? high : low) = share;
    }
    return (low + high) / 2;
  };
  const double fine = found_on(2 * n_wavy_nodes);
  return {fine, std::abs(fine - found_on(n_wavy_nodes)) + tolerance};
}

// When the first two valleys close, beside the rule: where the pressure of smooth cylinders,
// p₀√(P'/P − (x/a)²) under the load P', reaches p*.
void register_closing(Document& document, const ContactCase& c, const Hertz& hertz,
                      const WavyCylinders& wavy) {
  const double flat = std::pow(wavy.flattening_pressure / hertz.peak_pressure(), 2);
  std::vector<Criterion> late;
  for (int k = 0; k < 2; ++k) {
    const double x = (k + 0.5) * wavy.length;
    const double share = flat + std::pow(x / hertz.half_width(), 2);
    const Estimate rule{share, 2 * rounded(c, share)};
    const Estimate found = closing_share(c, wavy, x);
    const std::string key = fmt::format("wavy.closing.{}", k + 1);
    document.value(key + ".rule", Value(rule, fixed(3)));
    document.value(key + ".found", Value(found, uncertain()));
    document.value(key + ".late", Value(found / rule - 1, uncertain().in_percent()));
    late.push_back(Criterion::at_most("delay", Value(found / rule - 1, percent(1)),
                                      {LimitKind::choice, 0.05, "what was found, doubled"}));
  }
  document.check("valleys-close-late",
                 {Criterion::in_each("load that closes a valley, over that of the rule, less one",
                                     "valleys", late)},
                 "valleys close a little later than under an endless train of waves");
}

constexpr std::array shares_of_load = {1. / 64, 1. / 16, 1. / 4, 1. / 2, 3. / 4, 1., 3. / 2};

void register_regions(Document& document, const ContactCase& c, const WavyCylinders& wavy) {
  std::vector<std::size_t> counts;
  std::vector<Criterion> loads_with_valleys_as_expected;
  for (const double share : shares_of_load) {
    const double load = share * c.line_load;
    const Solution solution = line_contact::solve_by_fft(wavy.problem, load);
    const Hertz smooth(c.cylinders, load);
    const std::vector<line_contact::Region> regions = solution.regions();
    const int closed = closed_valleys(wavy, solution);
    const int expected = valleys_expected_closed(wavy, smooth);
    counts.push_back(regions.size());
    loads_with_valleys_as_expected.push_back(
        Criterion::agrees("difference", Value(closed - expected, integer()), Value(0, integer()),
                          {LimitKind::data, 0.0, "it is a count"}));
  }
  const std::size_t most = std::ranges::max(counts);
  document.value("wavy.most-regions", Value(static_cast<long>(most), integer()));
  document.value("wavy.lightest", Value(shares_of_load.front(), exact()));
  document.value("wavy.heaviest", Value(shares_of_load.back(), exact()));
  document.value("wavy.n-loads", Value(static_cast<long>(shares_of_load.size()), integer()));
  document.check("valleys-close",
                 {Criterion::in_each("valleys closed, more or fewer than expected", "loads",
                                     loads_with_valleys_as_expected)},
                 "valleys close where smooth cylinders have a pressure above that which flattens");
  const auto count = [](const char* what, std::size_t found, std::size_t asked,
                        const char* reason) {
    return Criterion::agrees(what, Value(static_cast<long>(found), integer()),
                             Value(static_cast<long>(asked), integer()),
                             {LimitKind::choice, 0.0, reason});
  };
  document.check(
      "regions-form-and-join",
      {count("regions under the lightest load", counts.front(), 1, "the middle crest"),
       Criterion::at_least("regions at most", Value(static_cast<long>(most), integer()),
                           {LimitKind::data, 3.0, "the middle crest and one on either side"}),
       Criterion::at_most(
           "regions under the heaviest load", Value(static_cast<long>(counts.back()), integer()),
           {LimitKind::method, static_cast<double>(most - 1), "fewer than at most"})},
      "regions appear, and join, as the load grows");
}

// Load → approach → load.
void check_round_trip(Document& document, const ContactCase& c, const WavyCylinders& wavy) {
  const auto method = [](const Problem& problem, double load) {
    constexpr double tolerance = 1e-12;
    return line_contact::solve_by_fft(problem, load, tolerance);
  };
  const Solution solution = method(wavy.problem, c.line_load / 2);
  const double approach = solution.approach(c.datum);
  const Solution again = line_contact::solve_for_approach(wavy.problem, approach, c.datum, method);
  const double difference = std::abs(again.line_load() / solution.line_load() - 1);
  document.check(
      "approach-gives-the-load-back",
      {Criterion::at_most("relative difference of the loads",
                          Value(difference, scientific(1).rounded_up()).as_is(),
                          {LimitKind::choice, 1e-11, "the tolerance of both solutions, and more"}),
       Criterion::agrees("nodes in contact", Value(again.n_in_contact(), integer()),
                         Value(solution.n_in_contact(), integer()),
                         {LimitKind::data, 0.0, "the same nodes"})},
      "the approach that a load makes gives the same load back");
}

}  // namespace

void compute_regions(Document& document, const Case& from) {
  const ContactCase& c = from.contact;
  const WavesCase& waves = c.waves.value();
  const Hertz hertz(c.cylinders, c.line_load);
  const WavyCylinders wavy = wavy_cylinders(c, waves, hertz);
  const std::string& unit = from.units.length;
  document.value("wavy.amplitude",
                 Value(wavy.amplitude, significant(4), unit).within(rounded(c, wavy.amplitude)));
  document.value("wavy.length",
                 Value(wavy.length, significant(3), unit).within(rounded(c, wavy.length)));
  document.value("wavy.waves", Value(waves.in_half_width, exact()));
  document.value("wavy.flattening-share", Value(waves.flattening_share, exact()));
  document.value("wavy.points", Value(waves.n_points, integer()));
  register_regions(document, c, wavy);
  register_closing(document, c, hertz, wavy);
  check_round_trip(document, c, wavy);
}

}  // namespace paper
