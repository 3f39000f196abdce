// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "elasticity/surface_quadrature.hpp"
#include "paper/conventions.hpp"
#include "paper/paper.hpp"

namespace paper {
namespace {

using elasticity::SurfaceQuadrature;

// A quadrature and the closed form at one point.
struct Comparison {
  Estimate quadrature;
  Estimate closed_form;

  Estimate difference() const { return abs(quadrature - closed_form); }
};
using Comparisons = std::vector<Comparison>;

template <class Quadrature, class ClosedForm>
Comparisons compare(const std::vector<double>& points, const Quadrature& quadrature,
                    const ClosedForm& closed_form) {
  Comparisons comparisons;
  for (const double x : points) comparisons.push_back({quadrature(x), closed_form(x)});
  return comparisons;
}

constexpr int nearest_decade = -4;
constexpr int farthest_decade = 4;

// Points over these decades of half-widths, thirteen per decade; one is the kink at x = a.
std::vector<double> wide_points(double half_width) {
  std::vector<double> points;
  constexpr int n_per_decade = 13;
  for (int i = 0; i <= n_per_decade * (farthest_decade - nearest_decade); ++i) {
    points.push_back(half_width *
                     std::pow(10.0, nearest_decade + i / static_cast<double>(n_per_decade)));
  }
  return points;
}

// The load of the case, counting its evaluations.
elasticity::Load counted(const HalfSpaceCase& c, const std::shared_ptr<long>& n_evaluations) {
  const elasticity::Load load = c.load;
  std::vector<numerics::Piece> pieces;
  for (const numerics::Piece& piece : load.normal.pieces()) {
    pieces.push_back({piece.begin, piece.end, [=](double s) {
                        ++*n_evaluations;
                        return piece.value(s);
                      }});
  }
  elasticity::Load counting;
  counting.normal = numerics::PiecewiseFunction(pieces);
  return counting;
}

// The number of evaluations of the load per point, averaged over the points of the case.
template <class Quadrature>
long n_evaluations(const HalfSpaceCase& c, const Quadrature& evaluate) {
  const auto n = std::make_shared<long>(0);
  const SurfaceQuadrature surface(c.material, counted(c, n), c.datum);
  *n = 0;
  for (const double x : c.points) evaluate(surface, x);
  return std::lround(static_cast<double>(*n) / static_cast<double>(c.points.size()));
}

Estimate largest_difference(const Comparisons& comparisons, double unit) {
  Estimate largest;
  for (const Comparison& c : comparisons) largest = max(largest, c.difference() / unit);
  return largest;
}

double largest_reported(const Comparisons& comparisons, double unit) {
  double largest = 0;
  for (const Comparison& c : comparisons) largest = std::max(largest, c.quadrature.abs_error);
  return largest / unit;
}

// The difference from the closed form at each point, relative to the errors of both.
Criterion within_errors(const std::vector<const Comparisons*>& all) {
  std::vector<Criterion> shares;
  for (const Comparisons* comparisons : all) {
    for (const Comparison& c : *comparisons) {
      const Estimate difference = c.difference();
      shares.push_back(Criterion::at_most(
          "share", Value(difference.value / difference.abs_error, significant(1)).as_is(),
          Limit(1, LimitKind::method,
                "the error that the quadrature reports at the same point, and the rounding of the "
                "closed form")));
    }
  }
  return Criterion::in_each("difference over the errors of quadrature and closed form",
                            "comparisons", shares);
}

}  // namespace

void compute_quadrature(Document& document, const Case& from) {
  const HalfSpaceCase& c = from.half_space;
  const SurfaceQuadrature surface(c.material, c.load, c.datum);
  const auto closed_gradient = [&](double x) { return gradient(c, x); };
  const auto closed_displacement = [&](double x) { return displacement(c, x); };
  const std::vector<double> points = wide_points(c.load.half_width());
  std::vector<double> all_points = points;
  all_points.insert(all_points.end(), c.points.begin(), c.points.end());

  const Comparisons by_gradient = compare(
      c.points, [&](double x) { return surface.normal_displacement_from_gradient(x); },
      closed_displacement);
  const Comparisons by_logarithm = compare(
      points, [&](double x) { return surface.normal_displacement(x); }, closed_displacement);
  const Comparisons gradients = compare(
      all_points, [&](double x) { return surface.normal_gradient(x); }, closed_gradient);

  document.value("quadrature.n-points", Value(std::ssize(points), integer()));
  document.value("quadrature.nearest-decade", Value(nearest_decade, integer()));
  document.value("quadrature.farthest-decade", Value(farthest_decade, integer()));

  const double k = displacement_scale(c);
  literate::Table table("quadrature",
                        {Column::text("quantity"), Column::text("by"), Column("points", integer()),
                         Column("evaluations", integer()), Column("difference", scientific(1)),
                         Column("reported error", scientific(1))});
  const auto add = [&](const char* what, const char* by, const Comparisons& comparisons, long n,
                       double unit) {
    const auto bound = [&](double number) {
      return Cell::latex(Value(number, scientific(1).rounded_up()).as_is().latex());
    };
    table.add_row({what, Cell::latex(by), std::ssize(comparisons), n,
                   bound(largest_difference(comparisons, unit).value),
                   bound(largest_reported(comparisons, unit))});
  };
  add("displacement", "integrating the gradient", by_gradient,
      n_evaluations(c, [](const auto& s, double x) { s.normal_displacement_from_gradient(x); }), k);
  add("displacement", "$\\ln|x - s|$", by_logarithm,
      n_evaluations(c, [](const auto& s, double x) { s.normal_displacement(x); }), k);
  add("gradient", "$1/(x - s)$", gradients,
      n_evaluations(c, [](const auto& s, double x) { s.normal_gradient(x); }),
      k / c.load.half_width());
  document.table(table);

  const Limit aim = Limit(1e-10, LimitKind::choice, "ten digits of the scale $K$");
  const auto at_most = [&](const char* what, const Comparisons& comparisons) {
    return Criterion::at_most(
        what, Value(largest_difference(comparisons, k), scientific(1).rounded_up()), aim);
  };
  document.claim(
      "equation-3-follows",
      {.route =
           "quadrature of eq.~(2), integrated from the datum at the points of the case, and of "
           "the logarithm over eight decades of distance",
       .expected = Verdict::holds,
       .criteria = {
           at_most("largest difference from eq.~(3) over $K$, by the gradient", by_gradient),
           at_most("by the logarithm", by_logarithm),
           within_errors({&gradients, &by_logarithm, &by_gradient})}});
}

}  // namespace paper
