// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <vector>

#include "elasticity/concentrated_load.hpp"
#include "elasticity/load_shapes.hpp"
#include "elasticity/surface_quadrature.hpp"
#include "paper/bounds.hpp"
#include "paper/paper.hpp"

namespace paper {
namespace {

using elasticity::SurfaceQuadrature;

void register_parameters(Document& document, const HalfSpaceCase& half_space,
                         const UnitSystem& units) {
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

// Nodes over an elliptic pressure, as many as can be told apart in print.
Figure elements() {
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
    height.insert(height.end(), {0, pressure.back(), 0, literate::gap});
  }
  return {.width_cm = 7,
          .height_cm = 4,
          .data = {{"nodes", {{"x", x}, {"pressure", pressure}}},
                   {"triangles", {{"x", triangle_x}, {"height", height}}}},
          .numbers = {{"x_j", shown}, {"p_j", pressure_at(shown)}}};
}

constexpr double steps_ratio = 1000;  // of distances, towards a point where something is infinite

// Eq. (2) for a triangular, a uniform and a concentrated load of the same resultant, over K/a.
Figure gradients(const HalfSpaceCase& half_space) {
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
    under_force.push_back(is_middle ? literate::gap
                                    : concentrated.normal_gradient(xi * a).value / unit);
  }
  return {.width_cm = 8,
          .height_cm = 4.8,
          .data = {{"loads",
                    {{"x", x},
                     {"concentrated", under_force},
                     {"uniform", under_uniform},
                     {"triangular", under_triangle}}}}};
}

// Begins so near that what else depends on x is below a thousandth, and ends before x is rounded.
template <typename Step>
std::vector<Criterion> steps_towards(double from, const Step& step) {
  std::vector<Criterion> steps;
  constexpr int n_steps = 3;
  double distance = from;
  for (int i = 0; i < n_steps; ++i) {
    steps.push_back(step(distance, distance / steps_ratio));
    distance /= steps_ratio;
  }
  return steps;
}

// Three steps towards the force, each to a thousandth of the distance.
void check_force(Document& document, const HalfSpaceCase& c, const UnitSystem& units) {
  const SurfaceQuadrature surface(c.material, elasticity::ConcentratedLoad(c.load.line_load()),
                                  c.datum);
  const Value expected = Value(
      closed_form(c.material.integral_compliance() * c.load.line_load() * std::log(steps_ratio)),
      scientific(3), units.length);
  const auto step = [&](double from, double to) {
    const Estimate gain = surface.normal_displacement_from_gradient(to) -
                          surface.normal_displacement_from_gradient(from);
    return Criterion::agrees_relatively(
        "one step", Value(gain, scientific(3), units.length), expected,
        {LimitKind::choice, 1e-9,
         "nine digits: beside a force the gradient is proportional to "
         "1/𝑥, so that each step adds 𝐾 ln(1000), and the "
         "quadrature reports much smaller errors"});
  };
  document.check("force-sinks-without-limit",
                 {Criterion::in_each("what a step to a thousandth of the distance adds", "steps",
                                     steps_towards(c.load.half_width(), step))},
                 "under a force equal steps in the logarithm of the distance add equal "
                 "displacements, without end");
}

// Beside the end of a uniform pressure: what the gradient gains in each step, and u_z at the end.
void check_uniform(Document& document, const HalfSpaceCase& c) {
  const double a = c.load.half_width();
  const double pressure = c.load.line_load() / (2 * a);
  const SurfaceQuadrature surface(c.material, elasticity::UniformLoad(pressure, a), c.datum);
  const double unit = c.material.integral_compliance() * c.load.line_load();
  constexpr double beside = 1e-9;
  const Estimate difference =
      surface.normal_displacement(a * (1 + beside)) - surface.normal_displacement(a);
  document.check(
      "uniform-displacement-finite",
      {Criterion::at_most(
          "change of the displacement from the end to ε = 10⁻⁹ half-widths beside it, over 𝐾",
          Value(abs(1 / unit * difference), scientific(2).rounded_up()),
          Limit::theory("ε[1 + ln(2/ε)]", {{"ε", beside}},
                        "twice what a gradient adds that grows logarithmically"))},
      "the displacement under a uniform pressure is finite at its ends");

  const Value expected =
      Value(closed_form(c.material.integral_compliance() * pressure * std::log(steps_ratio)),
            scientific(3));
  const auto step = [&](double from, double to) {
    const Estimate gain = abs(surface.normal_gradient(a + to) - surface.normal_gradient(a + from));
    return Criterion::agrees_relatively(
        "one step", Value(gain, scientific(3)), expected,
        Limit::theory(
            "𝑑/𝑎", {{"𝑑", 1e-3 * a}, {"𝑎", a}},
            "beside the end the gradient is logarithmic, and each step adds 𝐾𝑝/𝑃 ln(1000); what "
            "else changes is smooth and of this order, 𝑑 the distance at which the steps begin"));
  };
  document.check("uniform-gradient-infinite",
                 {Criterion::in_each("what a step to a thousandth of the distance adds", "steps",
                                     steps_towards(1e-3 * a, step))},
                 "beside the end of a uniform pressure the slope grows without end");
}

// On both sides of each kink of the triangle: is the gradient continuous, and its slope finite?
void check_smooth(Document& document, const HalfSpaceCase& c) {
  const double a = c.load.half_width();
  const SurfaceQuadrature surface(c.material, c.load, c.datum);
  const double unit = c.material.integral_compliance() * c.load.line_load() / a;
  const auto jump = [&](double kink, double d) {
    return 1 / unit *
           abs(surface.normal_gradient(kink + d * a) - surface.normal_gradient(kink - d * a));
  };
  std::vector<Criterion> continuous, sharp;
  for (const double kink : {-a, 0.0, a}) {
    for (const double d : {1e-3, 1e-6, 1e-9}) {
      continuous.push_back(Criterion::at_most(
          "change of the slope",
          Value(1 / (d * (1 + std::log(1 / d))) * jump(kink, d), significant(2)),
          Limit::theory("2·4", {},
                        "twice that of eq. (3) at the peak, 4𝑑[1 + ln(1/𝑑)]𝐾/𝑎, which vanishes "
                        "with 𝑑")));
    }
    sharp.push_back(Criterion::at_least(
        "growth", Value(1e6 * jump(kink, 1e-6) - 1e3 * jump(kink, 1e-3), significant(3)),
        Limit::theory("0.95·2 ln(𝑟)", {{"𝑟", steps_ratio}},
                      "95 % of what eq. (3) has at the ends, 𝑟 the ratio of the distances; at the "
                      "peak it has twice that")));
  }
  document.check(
      "triangles-smooth",
      {Criterion::in_each("change of the slope across a kink, over 𝐾/𝑎 and over 𝑑[1 + ln(1/𝑑)]",
                          "pairs of points", continuous)},
      "the slope is continuous across the kinks of a triangle");
  document.check("triangles-curvature",
                 {Criterion::in_each("growth of the slope's change over d, over K/a², when d falls "
                                     "to a thousandth",
                                     "kinks", sharp)},
                 "the curvature of the surface grows without bound where a triangle has a kink");
}

}  // namespace

void compute_formulation(Document& document, const Case& from) {
  const HalfSpaceCase& c = from.half_space;
  const UnitSystem& units = from.units;
  register_parameters(document, c, units);
  document.figure("triangular-elements", elements());
  check_force(document, c, units);
  check_uniform(document, c);
  check_smooth(document, c);
  document.figure("surface-gradient", gradients(c));
}

}  // namespace paper
