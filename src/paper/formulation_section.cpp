// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>
#include <vector>

#include "contact/hertz.hpp"
#include "elasticity/concentrated_load.hpp"
#include "elasticity/surface_quadrature.hpp"
#include "elasticity/uniform_load.hpp"
#include "figures/contact_geometry.hpp"
#include "figures/surface_gradient.hpp"
#include "figures/triangular_elements.hpp"
#include "paper/sections.hpp"

namespace paper {
namespace {

using literate::Value;

void register_parameters(literate::Document& document, const parameters::Case& from_file) {
  const parameters::HalfSpaceCase& half_space = from_file.half_space;
  const parameters::UnitSystem& units = from_file.units;
  document.value("units.length", Value::text(units.length));
  document.value("units.force", Value::text(units.force));
  document.value("units.stress", Value::text(units.stress));
  document.value("units.line-load", Value::text(units.line_load));
  document.value("young", Value::exact(half_space.material.young(), units.stress));
  document.value("poisson", Value::exact(half_space.material.poisson()));
  document.value("peak-pressure", Value::exact(half_space.load.peak_pressure(), units.stress));
  document.value("half-width", Value::exact(half_space.load.half_width(), units.length));
  document.value("line-load", Value::significant(half_space.load.line_load(), 4, units.line_load));
  document.value("datum", Value::exact(half_space.datum, units.length));
  document.value("n-points", Value::integer(std::ssize(half_space.points)));
  const double k = half_space.material.integral_compliance() * half_space.load.line_load();
  document.value("displacement-scale", Value::scientific(k, 4, units.length));
}

// Two like cylinders under a load that makes the deformation visible; lengths over the half-width.
figures::ContactGeometry geometry() {
  const elasticity::Material material(1, 0);
  const auto radius = contact::Radius::of_cylinder("radius", 1);
  const contact::CylinderPair cylinders(material, radius, material, radius);
  const contact::Hertz hertz(cylinders, 1);
  const double a = hertz.half_width();
  const double unit = cylinders.initial_gap(a);  // h at the edge of the contact
  constexpr double approach = 2.4;               // δ in that unit: where the datum is chosen
  constexpr double end = 2.2;

  figures::ContactGeometry g{};
  const auto before = [&](double xi) {
    return (approach - cylinders.initial_gap(xi * a) / unit) / 2;
  };
  constexpr int n = 220;
  for (int i = 0; i <= n; ++i) {
    const double xi = end * (2.0 * i / n - 1);
    const double after = -hertz.gap(xi * a) / unit / 2;
    g.x.push_back(xi);
    g.before1.push_back(before(xi));
    g.before2.push_back(-before(xi));
    g.after1.push_back(after);
    g.after2.push_back(-after);
  }
  g.apex = before(0);
  g.x_of_u = 0.55;
  g.before_at_u = before(g.x_of_u);
  g.x_of_h = 1.9;
  g.before_at_h = before(g.x_of_h);
  g.height = 1.7;
  return g;
}

// Nodes over an elliptic pressure, as many as can be told apart in print.
figures::TriangularElements elements() {
  figures::TriangularElements e;
  constexpr int n_each_side = 5;
  for (int j = -n_each_side; j <= n_each_side; ++j) {
    const double share = j / static_cast<double>(n_each_side);
    e.x.push_back(j);
    e.pressure.push_back(std::sqrt(1 - share * share));
  }
  return e;
}

// begin excerpt: three-loads
// Eq. (2) for a triangular, a uniform and a concentrated load of the same resultant, over K/a.
figures::SurfaceGradient gradients(const parameters::HalfSpaceCase& half_space) {
  const double a = half_space.load.half_width();
  const double resultant = half_space.load.line_load();
  const double unit = half_space.material.integral_compliance() * resultant / a;
  const auto surface_under = [&](const elasticity::Load& load) {
    return elasticity::SurfaceQuadrature(half_space.material, load, half_space.datum);
  };
  const auto triangular = surface_under(half_space.load);
  const auto uniform = surface_under(elasticity::UniformLoad(resultant / (2 * a), a));
  const auto concentrated = surface_under(elasticity::ConcentratedLoad(resultant));

  figures::SurfaceGradient g;
  constexpr int n = 601;  // odd, and no abscissa at 0 or ±a, where two of the three are infinite
  for (int i = 0; i < n; ++i) {
    const double xi = 3.003 * (2.0 * i / (n - 1) - 1);
    const bool is_middle = 2 * i + 1 == n;
    g.x.push_back(xi);
    g.triangular.push_back(triangular.normal_gradient(xi * a).value / unit);
    g.uniform.push_back(uniform.normal_gradient(xi * a).value / unit);
    g.concentrated.push_back(is_middle ? std::numeric_limits<double>::quiet_NaN()
                                       : concentrated.normal_gradient(xi * a).value / unit);
  }
  return g;
}
// end excerpt: three-loads

}  // namespace

void compute_formulation(literate::Document& document, const parameters::Case& from_file) {
  register_parameters(document, from_file);
  document.figure("contact-geometry", 11, 6.4, [g = geometry()](literate::Plot& plot) {
    figures::draw_contact_geometry(plot, g);
  });
  document.figure("triangular-elements", 11, 4.6, [e = elements()](literate::Plot& plot) {
    figures::draw_triangular_elements(plot, e);
  });
  document.figure("surface-gradient", 11, 7,
                  [g = gradients(from_file.half_space)](literate::Plot& plot) {
                    figures::draw_surface_gradient(plot, g);
                  });
}

}  // namespace paper
