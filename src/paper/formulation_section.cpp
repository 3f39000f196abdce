// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <vector>

#include "elasticity/loads.hpp"
#include "elasticity/surface_quadrature.hpp"
#include "paper/conventions.hpp"
#include "paper/paper.hpp"

namespace paper {
namespace {

// An elliptic pressure with as many nodes as remain distinct in print.
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
          .height_cm = 3.7,
          .data = {{"nodes", {{"x", x}, {"pressure", pressure}}},
                   {"triangles", {{"x", triangle_x}, {"height", height}}}},
          .numbers = {{"x_j", shown}, {"p_j", pressure_at(shown)}}};
}

// Eq. (2) for a triangular, a uniform and a concentrated load of the same resultant, over K/a.
Figure gradients(const HalfSpaceCase& half_space) {
  const double a = half_space.load.half_width();
  const double resultant = half_space.load.line_load();
  const double unit = displacement_scale(half_space) / a;
  const auto surface_under = [&](const elasticity::Load& load) {
    return elasticity::SurfaceQuadrature(half_space.material, load, half_space.datum);
  };
  const auto triangular = surface_under(half_space.load);
  const auto uniform = surface_under(elasticity::UniformLoad(resultant / (2 * a), a));
  const auto concentrated = surface_under(elasticity::ConcentratedLoad(resultant));

  std::vector<double> x, under_triangle, under_uniform, under_force;
  constexpr int n = 601;  // odd; no abscissa but 0 falls on a singularity of the three
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
          .height_cm = 4.4,
          .data = {{"loads",
                    {{"x", x},
                     {"concentrated", under_force},
                     {"uniform", under_uniform},
                     {"triangular", under_triangle}}}}};
}

}  // namespace

void compute_formulation(Document& document, const Case& from) {
  const HalfSpaceCase& c = from.half_space;
  const UnitSystem& units = from.units;
  document.value("young", Value(c.material.young(), exact(), units.stress));
  document.value("poisson", Value(c.material.poisson(), exact()));
  document.value("peak-pressure", Value(c.load.peak_pressure(), exact(), units.stress));
  document.value("half-width", Value(c.load.half_width(), exact(), units.length));
  document.value("line-load", Value(c.load.line_load(), significant(4), units.line_load).as_is());
  document.value("datum", Value(c.datum, exact(), units.length));
  document.value("n-points", Value(std::ssize(c.points), integer()));
  document.value("last-point", Value(Estimate{c.farthest_point(), 0}, fixed(decimals_of(c.points)),
                                     units.length));
  document.value("displacement-scale",
                 Value(displacement_scale(c), scientific(4), units.length).as_is());
  document.figure("triangular-elements", elements());
  document.figure("surface-gradient", gradients(c));
}

}  // namespace paper
