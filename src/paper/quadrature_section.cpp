// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include "elasticity/surface_quadrature.hpp"
#include "literate/document/document.hpp"
#include "paper/decimals.hpp"
#include "parameters/case.hpp"

namespace paper {
namespace {

using elasticity::SurfaceQuadrature;
using literate::Column;
using literate::confirmed_if;
using literate::fixed;
using literate::integer;
using literate::scientific;
using literate::significant;
using literate::Value;
using literate::Verdict;
using numerics::Estimate;

// A quadrature beside the closed form at one point.
struct Comparison {
  double x;
  Estimate quadrature;
  double closed_form;

  double difference() const { return quadrature.value - closed_form; }
  bool is_within_error() const { return std::abs(difference()) <= quadrature.abs_error; }
};

using Comparisons = std::vector<Comparison>;

Comparisons compare_gradients(const parameters::HalfSpaceCase& c,
                              const std::vector<double>& points) {
  const SurfaceQuadrature surface(c.material, c.load, c.datum);
  Comparisons comparisons;
  for (const double x : points) {
    comparisons.push_back({x, surface.normal_gradient(x), normal_gradient(c.material, c.load, x)});
  }
  return comparisons;
}

Comparisons compare_displacements(const parameters::HalfSpaceCase& c,
                                  const std::vector<double>& points, bool from_gradient = false) {
  const SurfaceQuadrature surface(c.material, c.load, c.datum);
  Comparisons comparisons;
  for (const double x : points) {
    comparisons.push_back({x,
                           from_gradient ? surface.normal_displacement_from_gradient(x)
                                         : surface.normal_displacement(x),
                           normal_displacement(c.material, c.load, x, c.datum)});
  }
  return comparisons;
}

double largest_difference(const Comparisons& comparisons) {
  double largest = 0;
  for (const Comparison& c : comparisons) largest = std::max(largest, std::abs(c.difference()));
  return largest;
}

double largest_estimate(const Comparisons& comparisons) {
  double largest = 0;
  for (const Comparison& c : comparisons) largest = std::max(largest, c.quadrature.abs_error);
  return largest;
}

bool all_within_error(const Comparisons& comparisons) {
  return std::all_of(comparisons.begin(), comparisons.end(),
                     [](const Comparison& c) { return c.is_within_error(); });
}

// Points from 1e-4 to 1e4 half-widths, thirteen a decade; the kink at x = a is one of them.
std::vector<double> wide_points(double half_width) {
  std::vector<double> points;
  constexpr int n_a_decade = 13;
  constexpr int n_decades = 8;
  for (int i = 0; i <= n_a_decade * n_decades; ++i) {
    points.push_back(half_width * std::pow(10.0, -4 + i / static_cast<double>(n_a_decade)));
  }
  return points;
}

// The error that the quadrature reports is a bound, and the difference of the two numbers as they
// were computed is rounding: neither has an error of its own.
literate::Table comparison_table(const Comparisons& gradients, const Comparisons& displacements,
                                 int n_decimals, const config::UnitSystem& units) {
  std::vector<Column> columns{Column("$x$", fixed(n_decimals), units.length).exact()};
  const auto add = [&](const std::string& group, const std::string& unit) {
    columns.push_back(Column("eq.~(2)", significant(10), unit).under(group));
    columns.push_back(Column("error", scientific(1).rounded_up(), unit).under(group).exact());
    columns.push_back(Column("difference", scientific(1), unit).under(group).exact());
  };
  add("$\\partial u_z/\\partial x$", "");
  add("$u_z$", units.length);
  literate::Table table("quadrature", columns);
  for (std::size_t i = 0; i < gradients.size(); ++i) {
    const Comparison& g = gradients[i];
    const Comparison& u = displacements[i];
    table.add_row({g.x, g.quadrature, g.quadrature.abs_error, g.difference(), u.quadrature,
                   u.quadrature.abs_error, u.difference()});
  }
  return table;
}

// How often the load is evaluated for one gradient and one displacement, on average.
void count_evaluations(literate::Document& document, const parameters::HalfSpaceCase& c) {
  auto n_evaluations = std::make_shared<long>(0);
  const elasticity::Load load = c.load;
  std::vector<numerics::Piece> counting;
  for (const numerics::Piece& piece : load.normal.pieces()) {
    counting.push_back({piece.begin, piece.end, [=](double s) {
                          ++*n_evaluations;
                          return piece.value(s);
                        }});
  }
  elasticity::Load counted;
  counted.normal = numerics::PiecewiseFunction(counting);
  const SurfaceQuadrature surface(c.material, counted, c.datum);
  const auto average = [&](auto&& evaluate) {
    *n_evaluations = 0;
    for (const double x : c.points) evaluate(x);
    return static_cast<double>(*n_evaluations) / static_cast<double>(c.points.size());
  };
  document.value("quadrature.gradient.evaluations",
                 Value(average([&](double x) { surface.normal_gradient(x); }), fixed(0)));
  document.value("quadrature.displacement.evaluations",
                 Value(average([&](double x) { surface.normal_displacement(x); }), fixed(0)));
  document.value(
      "quadrature.from-gradient.evaluations",
      Value(average([&](double x) { surface.normal_displacement_from_gradient(x); }), fixed(0)));
}

// How far the quadratures are from the closed forms and how far they say they may be, against x/a.
// On logarithmic axes a difference of exactly zero is a gap.
literate::Figure error_figure(const Comparisons& gradients, const Comparisons& displacements,
                              double half_width, double displacement_unit) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double gradient_unit = displacement_unit / half_width;
  const auto errors = [&](const Comparisons& comparisons, double unit) -> literate::FigureData {
    std::vector<double> x, difference, estimate;
    for (const Comparison& c : comparisons) {
      x.push_back(c.x / half_width);
      difference.push_back(c.difference() == 0 ? nan : std::abs(c.difference()) / unit);
      estimate.push_back(c.quadrature.abs_error / unit);
    }
    return {{"x", x}, {"difference", difference}, {"estimate", estimate}};
  };
  return {.width_cm = 15,
          .height_cm = 6.4,
          .data = {{"gradient", errors(gradients, gradient_unit)},
                   {"displacement", errors(displacements, displacement_unit)}}};
}

void claim_quadrature(literate::Document& document, const Comparisons& gradients,
                      const Comparisons& displacements, const Comparisons& from_gradients,
                      double displacement_unit, double gradient_unit) {
  const double difference =
      std::max(largest_difference(displacements), largest_difference(from_gradients));
  document.claim(
      "equation-3-follows",
      {.sentence = "Putting eq. (4) into eq. (2) and integrating yields eq. (3).",
       .place = "paper, Problem Description, p. 5",
       .computed = Value(difference / displacement_unit, scientific(1).rounded_up()),
       .route = "eq. (2) by quadrature, integrated from the datum by quadrature, and the integral "
                "of the logarithm; the value is the largest difference, over K",
       .tolerance = "the error that each quadrature reports, at every point of the tables and over "
                    "eight decades",
       .expected = Verdict::confirmed,
       .found = confirmed_if(all_within_error(displacements) && all_within_error(from_gradients))});
  document.claim(
      "quadrature-knows-its-error",
      {.sentence = "The quadrature of eq. (2) is right within the error that it reports itself.",
       .place = "this report",
       .stated = Value(largest_estimate(gradients) / gradient_unit, scientific(1).rounded_up()),
       .computed = Value(largest_difference(gradients) / gradient_unit, scientific(1).rounded_up()),
       .route = "the derivative of eq. (3) in closed form; stated is the largest error reported, "
                "computed the largest difference, over K/a",
       .tolerance = "at each of the points the difference must be within the error reported there",
       .expected = Verdict::confirmed,
       .found = confirmed_if(all_within_error(gradients))});
}

}  // namespace

void compute_quadrature(literate::Document& document, const parameters::HalfSpaceCase& c,
                        const config::UnitSystem& units) {
  const double a = c.load.half_width();
  const double unit = c.material.integral_compliance() * c.load.line_load();

  const Comparisons gradients = compare_gradients(c, c.points);
  const Comparisons from_gradients = compare_displacements(c, c.points, true);
  document.table(comparison_table(gradients, from_gradients, decimals_of(c.points), units));
  count_evaluations(document, c);

  const std::vector<double> points = wide_points(a);
  const Comparisons wide_gradients = compare_gradients(c, points);
  const Comparisons wide_displacements = compare_displacements(c, points);
  document.value("quadrature.n-points", Value(std::ssize(points), integer()));
  document.value("quadrature.gradient.difference",
                 Value(largest_difference(wide_gradients) * a / unit, scientific(1).rounded_up()));
  document.value("quadrature.gradient.estimate",
                 Value(largest_estimate(wide_gradients) * a / unit, scientific(1).rounded_up()));
  document.value("quadrature.displacement.difference",
                 Value(largest_difference(wide_displacements) / unit, scientific(1).rounded_up()));
  document.value("quadrature.displacement.estimate",
                 Value(largest_estimate(wide_displacements) / unit, scientific(1).rounded_up()));
  document.value("quadrature.from-gradient.difference",
                 Value(largest_difference(from_gradients) / unit, scientific(1).rounded_up()));
  claim_quadrature(document, wide_gradients, wide_displacements, from_gradients, unit, unit / a);
  document.figure("quadrature-error", error_figure(wide_gradients, wide_displacements, a, unit));

  constexpr double promised = 1e-10;
  document.check("gradient-within-error",
                 all_within_error(wide_gradients) && all_within_error(gradients),
                 "eq. (2) by quadrature is within its error of the derivative of eq. (3)");
  document.check("displacement-within-error",
                 all_within_error(wide_displacements) && all_within_error(from_gradients),
                 "u_z by quadrature, by either route, is within its error of eq. (3)");
  document.check("quadrature-error-small",
                 largest_estimate(wide_gradients) <= promised * unit / a &&
                     largest_estimate(wide_displacements) <= promised * unit,
                 "the reported errors of the quadratures are at most 1e-10 of K/a and K");
}

}  // namespace paper
