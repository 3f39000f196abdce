// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "elasticity/surface_quadrature.hpp"
#include "paper/bounds.hpp"
#include "paper/paper.hpp"

namespace paper {
namespace {

using elasticity::SurfaceQuadrature;

// A quadrature beside the closed form at one point.
struct Comparison {
  double x;
  Estimate quadrature;
  Estimate closed_form;

  Estimate difference() const { return abs(quadrature - closed_form); }
};

using Comparisons = std::vector<Comparison>;

Comparisons compare_gradients(const HalfSpaceCase& c, const std::vector<double>& points) {
  const SurfaceQuadrature surface(c.material, c.load, c.datum);
  Comparisons comparisons;
  for (const double x : points) {
    comparisons.push_back({x, surface.normal_gradient(x), gradient(c, x)});
  }
  return comparisons;
}

Comparisons compare_displacements(const HalfSpaceCase& c, const std::vector<double>& points,
                                  bool from_gradient = false) {
  const SurfaceQuadrature surface(c.material, c.load, c.datum);
  Comparisons comparisons;
  for (const double x : points) {
    comparisons.push_back({x,
                           from_gradient ? surface.normal_displacement_from_gradient(x)
                                         : surface.normal_displacement(x),
                           displacement(c, x)});
  }
  return comparisons;
}

double largest_difference(const Comparisons& comparisons) {
  double largest = 0;
  for (const Comparison& c : comparisons) largest = std::max(largest, c.difference().value);
  return largest;
}

double largest_estimate(const Comparisons& comparisons) {
  double largest = 0;
  for (const Comparison& c : comparisons) largest = std::max(largest, c.quadrature.abs_error);
  return largest;
}

constexpr int nearest_decade = -4;
constexpr int farthest_decade = 4;

// Points over these decades of half-widths, thirteen a decade; the kink at x = a is one of them.
std::vector<double> wide_points(double half_width) {
  std::vector<double> points;
  constexpr int n_a_decade = 13;
  for (int i = 0; i <= n_a_decade * (farthest_decade - nearest_decade); ++i) {
    points.push_back(half_width *
                     std::pow(10.0, nearest_decade + i / static_cast<double>(n_a_decade)));
  }
  return points;
}

// How often the load is evaluated for one gradient and for one displacement by either route, on
// average over the points of the case.
struct Evaluations {
  long gradient, displacement, from_gradient;
};

Evaluations count_evaluations(const HalfSpaceCase& c) {
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
    return std::lround(static_cast<double>(*n_evaluations) / static_cast<double>(c.points.size()));
  };
  return {
      .gradient = average([&](double x) { surface.normal_gradient(x); }),
      .displacement = average([&](double x) { surface.normal_displacement(x); }),
      .from_gradient = average([&](double x) { surface.normal_displacement_from_gradient(x); })};
}

// The largest difference from the closed form, over a unit; wrong by what both say of themselves.
Estimate largest_over(const Comparisons& comparisons, double unit) {
  Estimate largest;
  for (const Comparison& c : comparisons) largest = max(largest, c.difference() / unit);
  return largest;
}

// What the quadratures are written for, and held to at random points by their tests.
Limit promised(const char* reason) {
  return {LimitKind::choice, 1e-10, reason};
}

// At each point the difference from the closed form, over the errors of both.
Criterion within_errors(const std::vector<const Comparisons*>& all) {
  std::vector<Criterion> shares;
  for (const Comparisons* comparisons : all) {
    for (const Comparison& c : *comparisons) {
      const Estimate difference = c.difference();
      shares.push_back(Criterion::at_most(
          "share", Value(difference.value / difference.abs_error, significant(1)).as_is(),
          {LimitKind::method, 1.0,
           "the error that the quadrature reports at the same point, and the rounding of the "
           "closed form"}));
    }
  }
  return Criterion::in_each(
      "differences of the gradient and of both displacements, over the errors of quadrature and "
      "closed form",
      "comparisons", shares);
}

void claim_quadrature(Document& document, const Comparisons& gradients,
                      const Comparisons& displacements, const Comparisons& from_gradients,
                      double displacement_unit) {
  const char* const reason = "ten digits of the scale 𝐾, the aim of the quadratures";
  document.claim(
      "equation-3-follows",
      {.route = "eq. (2) by quadrature, integrated from the datum by quadrature, at the points of "
                "the case; and the integral of the logarithm over eight decades of distance",
       .expected = Verdict::confirmed,
       .criteria = {Criterion::at_most("largest difference from eq. (3) by the gradient, over 𝐾",
                                       Value(largest_over(from_gradients, displacement_unit),
                                             scientific(1).rounded_up()),
                                       promised(reason)),
                    Criterion::at_most("by the logarithm",
                                       Value(largest_over(displacements, displacement_unit),
                                             scientific(1).rounded_up()),
                                       promised(reason)),
                    within_errors({&gradients, &displacements, &from_gradients})}});
}

}  // namespace

void compute_quadrature(Document& document, const Case& from) {
  const HalfSpaceCase& c = from.half_space;
  const double a = c.load.half_width();
  const double unit = c.material.integral_compliance() * c.load.line_load();

  const Comparisons gradients = compare_gradients(c, c.points);
  const Comparisons from_gradients = compare_displacements(c, c.points, true);
  const Evaluations evaluations = count_evaluations(c);

  const std::vector<double> points = wide_points(a);
  const Comparisons wide_gradients = compare_gradients(c, points);
  const Comparisons wide_displacements = compare_displacements(c, points);
  document.value("quadrature.n-points", Value(std::ssize(points), integer()));
  document.value("quadrature.nearest-decade", Value(nearest_decade, integer()));
  document.value("quadrature.farthest-decade", Value(farthest_decade, integer()));
  Comparisons all_gradients = wide_gradients;
  all_gradients.insert(all_gradients.end(), gradients.begin(), gradients.end());
  literate::Table table("quadrature",
                        {Column::text("quantity"), Column::text("by"), Column("points", integer()),
                         Column("evaluations", integer()), Column("difference", scientific(1)),
                         Column("reported error", scientific(1))});
  const auto add = [&](const char* what, const char* by, const Comparisons& comparisons,
                       long n_evaluations, double scale) {
    const auto bound = [&](double number) {
      return Cell::latex(Value(number / scale, scientific(1).rounded_up()).as_is().latex());
    };
    table.add_row({Cell::latex(what), Cell::latex(by), std::ssize(comparisons), n_evaluations,
                   bound(largest_difference(comparisons)), bound(largest_estimate(comparisons))});
  };
  add("displacement", "integrating the gradient", from_gradients, evaluations.from_gradient, unit);
  add("displacement", "$\\ln|x - s|$", wide_displacements, evaluations.displacement, unit);
  add("gradient", "$1/(x - s)$", all_gradients, evaluations.gradient, unit / a);
  document.table(table);
  claim_quadrature(document, all_gradients, wide_displacements, from_gradients, unit);

  const char* const reason = "ten digits of the scale, the aim of the quadratures";
  const auto reported = [&](const Comparisons& comparisons, double scale) {
    return Value(largest_estimate(comparisons) / scale, scientific(1).rounded_up()).as_is();
  };
  document.check("quadrature-error-small",
                 {Criterion::at_most("of the gradient, over K/a",
                                     reported(wide_gradients, unit / a), promised(reason)),
                  Criterion::at_most("of the displacement, over K",
                                     reported(wide_displacements, unit), promised(reason))},
                 "the errors that the quadratures report are small");
}

}  // namespace paper
