// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "line_contact/cylinder_friction.hpp"
#include "line_contact/cylinders.hpp"
#include "line_contact/element_field.hpp"
#include "line_contact/friction.hpp"
#include "line_contact/solver.hpp"
#include "numerics/scatter.hpp"
#include "paper/bounds.hpp"
#include "paper/conventions.hpp"
#include "paper/convergence.hpp"
#include "paper/paper.hpp"

namespace paper {
namespace {

using elasticity::PiecewiseLinearTraction;
using line_contact::McEwen;
using line_contact::ShearPoint;
using line_contact::SlidingHertz;
using line_contact::Solution;

// Below this depth, over the half-width, the greatest shear is sought: above it the kinks show
// that only elements have, and wherever bodies slide τ₁ = μp₀ on the surface itself.
constexpr double least_shear_depth = 0.1;

// The greatest shear beneath the surface of a body whose contact has the half-width a.
template <typename Body>
line_contact::ShearPoint greatest_shear(const Body& body, double a) {
  return line_contact::find_greatest_shear([&](double x, double z) { return body.stress(x, z); }, a,
                                           least_shear_depth * a);
}

// How wrong the shear beneath a solution's elements may be, over p₀: its pressures with at most
// twice their error, and what elasticity/interior_stress.hpp states of a sum of one sign, of which
// each component is less than 10 p₀.
double shear_error_of(const Solution& solution) {
  return 2 * pressure_error(solution) + 1e-13;
}

// McEwen's closed form, over p₀ (line_contact/cylinders.hpp, line_contact/cylinder_friction.hpp).
constexpr double of_mcewen = 1e-13;

// How wrong the place of the greatest shear may be, over a: the shear is known to so much only, its
// curvature there is 0.3 p₀/a² at least, and the search ends with steps of 1e-7 a.
double place_error(double shear_error) {
  constexpr double least_curvature = 0.3;
  return 1e-7 + std::sqrt(4 * shear_error / least_curvature);
}

constexpr std::array shear_levels = {0.05, 0.1, 0.15, 0.2, 0.25, 0.3};  // contours of τ₁/p₀

// The friction at which the surface, where τ₁ = μp₀, overtakes the greatest shear beneath: the
// middle of the bracket that bisection leaves.
Estimate friction_at_surface(const Hertz& hertz) {
  double low = 0.2;
  double high = 0.6;
  for (int i = 0; i < 12; ++i) {
    const double middle = (low + high) / 2;
    const ShearPoint beneath = greatest_shear(SlidingHertz(hertz, middle), hertz.half_width());
    (beneath.shear > middle * hertz.peak_pressure() ? low : high) = middle;
  }
  return {(low + high) / 2, (high - low) / 2};
}

// How far the elements are from McEwen at all |x| ≤ 1.5 a near the surface, and at the depth of the
// largest shear.
void compare_depths(Document& document, const PiecewiseLinearTraction& traction,
                    const Solution& solution, const Hertz& hertz, double depth_of_greatest) {
  const McEwen mcewen(hertz);
  const double a = hertz.half_width();
  const double bound = shear_error_of(solution) + of_mcewen;
  constexpr double near_surface = 0.01;
  constexpr double step = near_surface / 10;
  const auto largest_at = [&](double depth) {
    double largest = 0;
    for (int i = 0; i <= 1500; ++i) {  // both are symmetric
      const double x = i * step * a;
      const double difference =
          traction.stress(x, depth * a).max_shear() - mcewen.stress(x, depth * a).max_shear();
      largest = std::max(largest, std::abs(difference) / hertz.peak_pressure());
    }
    // Stresses at the depth z change over no less than z, so that a peak halfway between two points
    // is higher by (step/2)²/(2z²) of itself, 0.0013 at the least depth.
    return Estimate{largest, bound + 0.002 * largest};
  };
  const Estimate near = largest_at(near_surface);
  const Estimate deep = largest_at(depth_of_greatest);
  document.value("stresses.near", Value(near_surface, exact()));
  document.value("stresses.near.difference", Value(near, scientific(1).rounded_up()));
  document.value("stresses.at-greatest.difference", Value(deep, scientific(1).rounded_up()));
  document.check("stresses-decay",
                 {Criterion::at_least("largest difference near the surface over that at the "
                                      "depth of the largest shear stress",
                                      Value(near / deep, significant(1)),
                                      {LimitKind::choice, 10.0, "an order of magnitude"})},
                 "the largest difference falls down to the largest shear");
}

// Far below only the load and, next to it, the second moment of the pressure are felt:
// τ₁ = (P/πz)(1 − 3⟨x²⟩/z²), and ⟨x²⟩ = a²/4.
void compare_deep(Document& document, const PiecewiseLinearTraction& traction,
                  const Solution& solution, const Hertz& hertz) {
  constexpr double depth = 20;
  const double a = hertz.half_width();
  const double relative =
      traction.stress(0, depth * a).max_shear() / McEwen(hertz).stress(0, depth * a).max_shear() -
      1;
  const double width_error = solution.half_width() / a - 1;
  const double expected = -1.5 * width_error / (depth * depth);
  // So far below the shear goes with the load, which pressures wrong by δp₀ change by (4/π)δ.
  const double width_bound = half_width_error(solution) + rounded(1);
  document.check(
      "load-and-moment-felt-below",
      {Criterion::agrees(
          "relative difference of the shear",
          Value(Estimate{relative, shear_error_of(solution)}, scientific(2)),
          Value(Estimate{expected, 1.5 * width_bound / (depth * depth)}, scientific(2)),
          Limit::theory("(𝑐/𝑎)²(𝑎/𝑧)⁴", {{"𝑐", solution.grid.spacing}, {"𝑎", a}, {"𝑧", depth * a}},
                        "the next moment"))},
      "far below only the load and the second moment of the pressure are felt");
}

void compare_greatest(Document& document, const PiecewiseLinearTraction& traction,
                      const line_contact::GreatestShear& exact, const Solution& solution,
                      const Hertz& hertz) {
  const double a = hertz.half_width();
  const ShearPoint found = greatest_shear(traction, a);
  const double shear_error = std::abs(found.shear / exact.shear - 1);
  const double depth_error = std::abs(found.z - exact.depth) / a;
  const double p0 = hertz.peak_pressure();
  const double shear = exact.shear / p0;
  document.value("stresses.shear", Value(closed_form(shear), fixed(6)));
  // The elements' shear is over p₀, a third of it and more.
  const double shear_bound = 4 * shear_error_of(solution);
  // Rounding of the shear, 1e-13 at most, hides its maximum within √(4·1e-13/0.85) of the depth,
  // and the search ends with steps of 1e-7 a.
  constexpr double depth_bound = 8e-7;
  document.value("stresses.depth", Value(closed_form(exact.depth / a), fixed(6)));
  document.value("stresses.shear-error",
                 Value(Estimate{shear_error, shear_bound}, scientific(1).rounded_up()));
  document.value("stresses.depth-error",
                 Value(Estimate{depth_error, depth_bound}, scientific(1).rounded_up()));
  const double square = std::pow(solution.grid.spacing / a, 2);
  document.claim(
      "mcewen",
      {.route = "a search in the plane beneath the elements, against McEwen's closed form",
       .expected = Verdict::confirmed,
       .criteria = {
           Criterion::agrees("shear over 𝑝₀",
                             Value({found.shear / p0, shear_bound * shear}, significant(6)),
                             Value(closed_form(shear), significant(6)), of_second_order(square)),
           Criterion::agrees("depth over 𝑎", Value({found.z / a, depth_bound}, significant(6)),
                             Value(closed_form(exact.depth / a), significant(6)),
                             of_second_order(square))}});
}

// The errors of the shear at McEwen's depth; at each spacing the root mean square over grids on
// which the edge lies anywhere between two nodes.
void fit_order(Document& document, const ContactCase& c, const Hertz& hertz) {
  const auto exact = McEwen(hertz).greatest_shear();
  std::vector<double> elements;
  std::vector<Estimate> errors;
  for (const long n_nodes : {133L, 179L, 241L, 335L}) {
    constexpr double tolerance = 1e-12;
    std::vector<Estimate> errors_here;
    double logarithms = 0;
    for (const line_contact::Grid& grid : grids_of(hertz, n_nodes)) {
      const Solution solution = line_contact::solve_by_fft(
          {c.cylinders.profile(), c.cylinders.contact_modulus(), grid}, c.line_load, tolerance);
      const double shear =
          line_contact::traction_on(solution, {}).stress(0, exact.depth).max_shear();
      errors_here.push_back({shear / exact.shear - 1, 4 * shear_error_of(solution)});
      logarithms += std::log(hertz.half_width() / grid.spacing);
    }
    elements.push_back(std::exp(logarithms / n_edge_places));
    errors.push_back(root_mean_square(errors_here));
  }
  const Measured order = numerics::fit_scattered_power(elements, errors, "grids").order;
  document.value("stresses.fit.least", Value(closed_form(elements.front()), fixed(0)));
  document.value("stresses.fit.most", Value(closed_form(elements.back()), fixed(0)));
  document.value("stresses.fit.order", Value(order, uncertain()));
  document.check("stresses-order-two", {is_of_order("order", order, 2)},
                 "inside the body the stresses converge with order two");
}

void compare_sliding(Document& document, const FrictionCase& friction, const Solution& solution,
                     const Hertz& hertz) {
  const double a = hertz.half_width();
  const double square = std::pow(solution.grid.spacing / a, 2);
  double largest = 0;
  ShearPoint still{}, sliding{};
  const double between = (friction.light + friction.coefficient) / 2;
  for (const double mu : {0.0, friction.light, between, friction.coefficient}) {
    const auto traction =
        line_contact::traction_on(solution, line_contact::sliding(solution, mu).shear);
    const ShearPoint found = greatest_shear(traction, a);
    const ShearPoint exact = greatest_shear(SlidingHertz(hertz, mu), a);
    const double difference = found.shear / exact.shear - 1;
    largest = std::max(largest, std::abs(difference));
    (mu == 0 ? still : sliding) = exact;
  }
  document.value("stresses.sliding.rise",
                 Value(sliding.shear / still.shear - 1, percent(0)).within(4 * of_mcewen));
  document.value("stresses.sliding.depth-share",
                 Value(sliding.z / still.z, percent(0)).within(4 * place_error(of_mcewen)));
  document.value("stresses.surface-friction", Value(friction_at_surface(hertz), fixed(3)));
  document.check(
      "sliding-shear",
      {Criterion::at_most(
          "largest relative difference over (c/a)²",
          Value({largest / square, 4 * shear_error_of(solution) / square}, significant(2)),
          {LimitKind::choice, 0.6, "what was found, with a margin"})},
      "beneath sliding cylinders the elements find the largest shear to second order");
}

// The shear on the surface of sliding cylinders is μp₀ wherever they touch.
void check_surface(Document& document, const Solution& solution, const Hertz& hertz, double mu) {
  const auto traction =
      line_contact::traction_on(solution, line_contact::sliding(solution, mu).shear);
  const double expected = mu * hertz.peak_pressure();
  double largest = 0;
  for (int i = -40; i <= 40; ++i) {
    const double shear = traction.stress(0.02 * i * hertz.half_width(), 0).max_shear();
    largest = std::max(largest, std::abs(shear / expected - 1));
  }
  // On the surface errors of the shear add up like a logarithm, with 6 for any N up to 1000, and
  // are over μp₀ here.
  const double bound = 6 / mu * shear_error_of(solution);
  document.value("stresses.surface-difference",
                 Value(Estimate{largest, bound}, scientific(1).rounded_up()));
  const double square = std::pow(solution.grid.spacing / hertz.half_width(), 2);
  document.check("sliding-surface",
                 {Criterion::at_most("largest relative difference from μp₀, over (c/a)²",
                                     Value({largest / square, bound / square}, significant(2)),
                                     {LimitKind::choice, 1.5, "what was found, with a margin"})},
                 "on the surface of sliding cylinders the largest shear is mu p0");
}

// Points of the figure with the τ₁/p₀ there; lengths over the half-width.
struct ShearPoints {
  std::vector<double> x, z, tau;

  void add(double at_x, double at_z, double value) {
    x.push_back(at_x);
    z.push_back(at_z);
    tau.push_back(value);
  }
  operator FigureData() const { return {{"x", x}, {"z", z}, {"tau", tau}}; }
};

// Where τ₁/p₀ first falls through the level on the way from one point to another, if it does.
void add_label(ShearPoints& labels, const PiecewiseLinearTraction& traction, const Hertz& hertz,
               double level, ShearPoint from, ShearPoint to) {
  constexpr int n = 500;
  const double a = hertz.half_width();
  double before = 0;
  for (int i = 0; i <= n; ++i) {
    const double x = from.x + (to.x - from.x) * i / n;
    const double z = from.z + (to.z - from.z) * i / n;
    const double tau = traction.stress(x * a, z * a).max_shear() / hertz.peak_pressure();
    if (before >= level && tau < level) {
      labels.add(x, z, level);
      return;
    }
    before = tau;
  }
}

// Adds what one contact makes beneath: its field, the numbers of its contours, its greatest value.
void add_field(Figure& figure, const std::string& name, const Solution& solution,
               const Hertz& hertz, double mu) {
  const double a = hertz.half_width();
  const double p0 = hertz.peak_pressure();
  const auto traction =
      line_contact::traction_on(solution, line_contact::sliding(solution, mu).shear);
  const ShearPoint greatest = greatest_shear(traction, a);
  ShearPoints field, labels, peak;
  constexpr int n_along_x = 100, n_along_z = 60;
  for (int k = 0; k <= n_along_z; ++k) {
    const double z = 2.5 * std::pow(k / static_cast<double>(n_along_z), 1.5);
    for (int i = 0; i <= n_along_x; ++i) {
      const double x = 0.04 * i - 2;
      field.add(x, z, traction.stress(x * a, z * a).max_shear() / p0);
    }
  }
  peak.add(greatest.x / a, greatest.z / a, greatest.shear / p0);
  // The high levels are met on the way from the largest shear to a lower corner, the low ones on
  // the way up beside the contact.
  std::vector<double> levels;
  for (const double level : shear_levels) {
    constexpr double too_near =
        0.01;  // to the cross, with which contour and number would run together
    if (level > greatest.shear / p0 - too_near) continue;
    levels.push_back(level);
    const bool is_high = level > 0.12;
    add_label(labels, traction, hertz, level,
              is_high ? ShearPoint{greatest.x / a, greatest.z / a, 0} : ShearPoint{-1.6, 1.2, 0},
              is_high ? ShearPoint{-1.9, 2.45, 0} : ShearPoint{-1.6, 0, 0});
  }
  figure.data[name] = {FigureData(field).columns, n_along_x + 1};
  figure.data[name + "_labels"] = labels;
  figure.data[name + "_greatest"] = peak;
  figure.texts[name + "_levels"] = fmt::format("{}", fmt::join(levels, ", "));
  figure.numbers[name + "_friction"] = mu;
}

Figure shear_figure(const Solution& solution, const Hertz& hertz, double mu) {
  const double a = hertz.half_width();
  const double p0 = hertz.peak_pressure();
  Figure figure{.width_cm = 15.4, .height_cm = 4.6};
  add_field(figure, "still", solution, hertz, 0);
  add_field(figure, "sliding", solution, hertz, mu);

  // On the axis of the first: McEwen's closed form, and the elements.
  ShearPoints closed, nodes;
  const McEwen mcewen(hertz);
  for (int k = 0; k <= 200; ++k) {
    const double z = 0.0125 * k;
    closed.add(0, z, mcewen.stress(0, z * a).max_shear() / p0);
  }
  const auto traction = line_contact::traction_on(solution, {});
  for (int k = 0; k <= 20; ++k) {
    const double z = 0.125 * k;
    nodes.add(0, z, traction.stress(0, z * a).max_shear() / p0);
  }
  figure.data["closed"] = closed;
  figure.data["nodes"] = nodes;
  return figure;
}

}  // namespace

void compute_stresses(Document& document, const Case& from) {
  const ContactCase& c = from.contact;
  const FrictionCase& friction = c.friction.value();
  const Hertz hertz(c.cylinders, c.line_load);
  const Solution solution = invert_cylinders(c, hertz);
  const PiecewiseLinearTraction traction = line_contact::traction_on(solution, {});
  const line_contact::GreatestShear exact = McEwen(hertz).greatest_shear();

  compare_greatest(document, traction, exact, solution, hertz);
  compare_depths(document, traction, solution, hertz, exact.depth / hertz.half_width());
  compare_deep(document, traction, solution, hertz);
  fit_order(document, c, hertz);
  compare_sliding(document, friction, solution, hertz);
  check_surface(document, solution, hertz, friction.coefficient);
  document.figure("shear-beneath", shear_figure(solution, hertz, friction.coefficient));
}

}  // namespace paper
