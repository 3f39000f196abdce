// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <cmath>
#include <limits>
#include <vector>

#include "contact/hertz.hpp"
#include "elasticity/concentrated_load.hpp"
#include "elasticity/surface_quadrature.hpp"
#include "elasticity/uniform_load.hpp"
#include "literate/document/document.hpp"
#include "paper/bounds.hpp"
#include "parameters/case.hpp"

namespace paper {
namespace {

using elasticity::SurfaceQuadrature;
using literate::confirmed_if;
using literate::exact;
using literate::integer;
using literate::scientific;
using literate::significant;
using literate::Value;
using literate::Verdict;

void register_parameters(literate::Document& document, const parameters::HalfSpaceCase& half_space,
                         const config::UnitSystem& units) {
  document.value("units.length", Value::text(units.length));
  document.value("units.force", Value::text(units.force));
  document.value("units.stress", Value::text(units.stress));
  document.value("units.line-load", Value::text(units.line_load));
  document.value("young", Value(half_space.material.young(), exact(), units.stress));
  document.value("poisson", Value(half_space.material.poisson(), exact()));
  document.value("peak-pressure", Value(half_space.load.peak_pressure(), exact(), units.stress));
  document.value("half-width", Value(half_space.load.half_width(), exact(), units.length));
  const double line_load = half_space.load.line_load();
  document.value("line-load",
                 Value(line_load, significant(4), units.line_load).within(rounded(line_load)));
  document.value("datum", Value(half_space.datum, exact(), units.length));
  document.value("n-points", Value(std::ssize(half_space.points), integer()));
  const double k = half_space.material.integral_compliance() * line_load;
  document.value("displacement-scale", Value(k, scientific(4), units.length).within(rounded(k)));
}

// Two like cylinders under a load that makes the deformation visible; lengths over the half-width.
// Heights are positive upwards.
literate::Figure geometry() {
  const elasticity::Material material(1, 0);
  const auto radius = contact::Radius::of_cylinder("radius", 1);
  const contact::CylinderPair cylinders(material, radius, material, radius);
  const contact::Hertz hertz(cylinders, 1);
  const double a = hertz.half_width();
  const double unit = cylinders.profile().gap(a);  // h at the edge of the contact
  constexpr double approach = 2.4;                 // δ in that unit: where the datum is chosen
  constexpr double end = 2.2;

  const auto height_before = [&](double xi) {
    return (approach - cylinders.profile().gap(xi * a) / unit) / 2;
  };
  std::vector<double> x, before1, before2, after1, after2;
  constexpr int n = 220;
  for (int i = 0; i <= n; ++i) {
    const double xi = end * (2.0 * i / n - 1);
    const double height_after = -hertz.gap(xi * a) / unit / 2;
    x.push_back(xi);
    before1.push_back(height_before(xi));
    before2.push_back(-height_before(xi));
    after1.push_back(height_after);
    after2.push_back(-height_after);
  }
  constexpr double x_of_u = 0.55;  // where the displacements are shown
  constexpr double x_of_h = 1.9;   // where the gap h = h₁ + h₂ is shown
  return {.width_cm = 11,
          .height_cm = 6.4,
          .data = {{"before", {{"x", x}, {"body1", before1}, {"body2", before2}}},
                   {"after", {{"x", x}, {"body1", after1}, {"body2", after2}}}},
          .numbers = {{"apex", height_before(0)},  // δ/2
                      {"x_of_u", x_of_u},
                      {"before_at_u", height_before(x_of_u)},
                      {"x_of_h", x_of_h},
                      {"before_at_h", height_before(x_of_h)},
                      {"height", 1.7}}};
}

// Nodes over an elliptic pressure, as many as can be told apart in print.
literate::Figure elements() {
  constexpr double gap = std::numeric_limits<double>::quiet_NaN();
  constexpr int n_each_side = 5;
  constexpr int shown = 2;  // the node whose p_j and c are labelled
  const auto pressure_at = [](int node) {
    const double share = node / static_cast<double>(n_each_side);
    return std::sqrt(1 - share * share);
  };
  std::vector<double> x, pressure;
  std::vector<double> triangle_x, height;  // one curve of all triangles, with a gap after each
  for (int j = -n_each_side; j <= n_each_side; ++j) {
    x.push_back(j);
    pressure.push_back(pressure_at(j));
    if (pressure.back() == 0) continue;
    triangle_x.insert(triangle_x.end(), {j - 1.0, j + 0.0, j + 1.0, j + 1.0});
    height.insert(height.end(), {0, pressure.back(), 0, gap});
  }
  return {.width_cm = 11,
          .height_cm = 4.6,
          .data = {{"nodes", {{"x", x}, {"pressure", pressure}}},
                   {"triangles", {{"x", triangle_x}, {"height", height}}}},
          .numbers = {{"x_j", shown}, {"p_j", pressure_at(shown)}}};
}

constexpr double steps_ratio = 1000;  // of distances, towards a point where something is infinite

// begin excerpt: three-loads
// Eq. (2) for a triangular, a uniform and a concentrated load of the same resultant, over K/a.
literate::Figure gradients(const parameters::HalfSpaceCase& half_space) {
  const double a = half_space.load.half_width();
  const double resultant = half_space.load.line_load();
  const double unit = half_space.material.integral_compliance() * resultant / a;
  const auto surface_under = [&](const elasticity::Load& load) {
    return elasticity::SurfaceQuadrature(half_space.material, load, half_space.datum);
  };
  const auto triangular = surface_under(half_space.load);
  const auto uniform = surface_under(elasticity::UniformLoad(resultant / (2 * a), a));
  const auto concentrated = surface_under(elasticity::ConcentratedLoad(resultant));

  std::vector<double> x, under_triangle, under_uniform, under_force;
  constexpr int n = 601;  // odd, and no abscissa at 0 or ±a, where two of the three are infinite
  for (int i = 0; i < n; ++i) {
    const double xi = 3.003 * (2.0 * i / (n - 1) - 1);
    const bool is_middle = 2 * i + 1 == n;
    x.push_back(xi);
    under_triangle.push_back(triangular.normal_gradient(xi * a).value / unit);
    under_uniform.push_back(uniform.normal_gradient(xi * a).value / unit);
    under_force.push_back(is_middle ? std::numeric_limits<double>::quiet_NaN()
                                    : concentrated.normal_gradient(xi * a).value / unit);
  }
  return {.width_cm = 11,
          .height_cm = 7,
          .data = {{"loads",
                    {{"x", x},
                     {"concentrated", under_force},
                     {"uniform", under_uniform},
                     {"triangular", under_triangle}}}}};
}
// end excerpt: three-loads

// Three steps towards the force, each to a thousandth of the distance.
void claim_force(literate::Document& document, const parameters::HalfSpaceCase& c,
                 const config::UnitSystem& units) {
  const double a = c.load.half_width();
  const SurfaceQuadrature surface(c.material, elasticity::ConcentratedLoad(c.load.line_load()),
                                  c.datum);
  const double expected =
      c.material.integral_compliance() * c.load.line_load() * std::log(steps_ratio);
  bool grows = true;
  for (double x = a; x > 1e-8 * a; x /= steps_ratio) {
    const numerics::Estimate step = surface.normal_displacement_from_gradient(x / steps_ratio) -
                                    surface.normal_displacement_from_gradient(x);
    grows = grows && std::abs(step.value - expected) <= step.abs_error + 1e-12 * expected;
  }
  document.claim("force-sinks-without-limit",
                 {.sentence = "Under a concentrated force the displacement is infinite.",
                  .place = "paper, Problem Description, p. 4",
                  .computed = Value(closed_form(expected), scientific(3), units.length),
                  .route = "eq. (2) integrated from the datum to points ever nearer to the force; "
                           "the value is what each step to a thousandth of the distance adds",
                  .tolerance = "three such steps add the same within the quadrature's error, so "
                               "that their sum has no limit",
                  .expected = Verdict::confirmed,
                  .found = confirmed_if(grows)});
}

// Beside the end of a uniform pressure: what the gradient gains in each step, and u_z at the end.
void claim_uniform(literate::Document& document, const parameters::HalfSpaceCase& c,
                   const config::UnitSystem& units) {
  const double a = c.load.half_width();
  const double pressure = c.load.line_load() / (2 * a);
  const SurfaceQuadrature surface(c.material, elasticity::UniformLoad(pressure, a), c.datum);
  const double unit = c.material.integral_compliance() * c.load.line_load();
  const numerics::Estimate at_end = surface.normal_displacement(a);
  const double beside = surface.normal_displacement(a * (1 + 1e-9)).value - at_end.value;
  document.claim("uniform-displacement-finite",
                 {.sentence = "Under uniform pressures the displacement is finite everywhere.",
                  .place = "paper, Problem Description, p. 4",
                  .computed = Value(at_end, scientific(3), units.length),
                  .route = "the integral of the logarithm at the very end of the pressure",
                  .tolerance = "10⁻⁹ half-widths beside the end it differs by no more than 10⁻⁷ of "
                               "the scale K: a gradient that is infinite like a logarithm adds "
                               "about 10⁻⁸",
                  .expected = Verdict::confirmed,
                  .found = confirmed_if(std::abs(beside) < 1e-7 * unit)});

  const double expected = c.material.integral_compliance() * pressure * std::log(steps_ratio);
  bool grows = true;
  for (double gap = 1e-3 * a; gap > 1e-10 * a; gap /= steps_ratio) {
    const double step = surface.normal_gradient(a + gap / steps_ratio).value -
                        surface.normal_gradient(a + gap).value;
    grows = grows && std::abs(std::abs(step) / expected - 1) < 1e-3;
  }
  document.claim("uniform-gradient-infinite",
                 {.sentence = "Where a uniform pressure ends in a step, the gradient is infinite.",
                  .place = "paper, Problem Description, p. 4",
                  .computed = Value(closed_form(expected), scientific(3)),
                  .route = "eq. (2) by quadrature at points ever nearer to the step; the value is "
                           "what each step to a thousandth of the distance adds",
                  .tolerance = "three such steps add the same to 10⁻³, the distance at which they "
                               "begin, so that their sum has no limit",
                  .expected = Verdict::confirmed,
                  .found = confirmed_if(grows)});
}

// On both sides of each kink of the triangle: does the gradient jump, is its slope finite?
void claim_smooth(literate::Document& document, const parameters::HalfSpaceCase& c) {
  const double a = c.load.half_width();
  const SurfaceQuadrature surface(c.material, c.load, c.datum);
  const double unit = c.material.integral_compliance() * c.load.line_load() / a;
  const auto jump = [&](double kink, double h) {
    return std::abs(surface.normal_gradient(kink + h * a).value -
                    surface.normal_gradient(kink - h * a).value) /
           unit;
  };
  int n_continuous = 0;
  int n_sharp = 0;
  for (const double kink : {-a, 0.0, a}) {
    n_continuous += jump(kink, 1e-6) < 1e-4 && jump(kink, 1e-9) < 1e-7;
    n_sharp += jump(kink, 1e-6) / 1e-6 > jump(kink, 1e-3) / 1e-3 + 5;
  }
  const Verdict smooth = n_sharp == 0 ? Verdict::confirmed : Verdict::partly;
  document.claim(
      "triangles-smooth",
      {.sentence = "Overlapping triangles give displacements that are everywhere smooth and "
                   "continuous.",
       .place = "paper, Problem Description, p. 4; Conclusions, p. 9",
       .computed = Value::text(fmt::format(
           "slope continuous at {} of 3 kinks, curvature infinite at {}", n_continuous, n_sharp)),
       .route = "eq. (2) by quadrature on both sides of the triangle's ends and of its peak",
       .tolerance = "h beside a kink the slope differs by less than 100 h/a of K/a, which leaves "
                    "room for a logarithm; smooth in full would be a curvature that does not grow "
                    "as h falls",
       .expected = Verdict::partly,
       .found = n_continuous == 3 ? smooth : Verdict::refuted});
}

}  // namespace

void compute_formulation(literate::Document& document, const parameters::HalfSpaceCase& c,
                         const config::UnitSystem& units) {
  register_parameters(document, c, units);
  document.figure("contact-geometry", geometry());
  document.figure("triangular-elements", elements());
  claim_force(document, c, units);
  claim_uniform(document, c, units);
  claim_smooth(document, c);
  document.figure("surface-gradient", gradients(c));
}

}  // namespace paper
