// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "paper/paper.hpp"
#include "point_contact/methods.hpp"

namespace paper {
namespace {

using Eigen::Index;
using point_contact::Vector2;

constexpr Index n_nodes = 96;  // along each side of the square

double least_radius(const ContactCase& c) {
  return 1 / std::max(std::abs(c.body1.radius.curvature()), std::abs(c.body2.radius.curvature()));
}

// Lines of a drawing in three dimensions, two points each.
class Lines {
 public:
  void add(double x1, double y1, double z1, double x2, double y2, double z2) {
    x_.insert(x_.end(), {x1, x2});
    y_.insert(y_.end(), {y1, y2});
    z_.insert(z_.end(), {z1, z2});
  }
  FigureData data() const { return FigureData({{"x", x_}, {"y", y_}, {"z", z_}}, 2); }

 private:
  std::vector<double> x_, y_, z_;
};

// The pyramid at a node: on each of the six triangles around it the pressure is linear.
FigureData pyramid_at(int i, int j) {
  constexpr int ring[6][2] = {{1, 0}, {0, 1}, {-1, 1}, {-1, 0}, {0, -1}, {1, -1}};
  Lines lines;
  for (int k = 0; k < 6; ++k) {
    const int x = i + ring[k][0];
    const int y = j + ring[k][1];
    lines.add(x, y, 0, i + ring[(k + 1) % 6][0], j + ring[(k + 1) % 6][1], 0);
    lines.add(x, y, 0, i, j, 1);
  }
  return lines.data();
}

// Square cells, each cut into two triangles.
FigureData lattice() {
  constexpr int n = 2;
  Lines lines;
  for (int i = -n; i <= n; ++i) {
    lines.add(i, -n, 0, i, n, 0);
    lines.add(-n, i, 0, n, i, 0);
    for (int j = -n; j < n; ++j) {
      if (i < n) lines.add(i, j + 1, 0, i + 1, j, 0);
    }
  }
  return lines.data();
}

Figure sphere_figure(const Spheres& spheres) {
  constexpr double shown = 1.2;  // over a
  const double a = spheres.hertz.radius();
  const double p0 = spheres.hertz.peak_pressure();
  std::vector<double> x{-shown}, pressure{0}, row_x, row_pressure, r, difference;
  constexpr int n = 200;
  for (int i = -n; i <= n; ++i) {
    x.push_back(std::sin(std::numbers::pi / 2 * i / n));
    pressure.push_back(spheres.hertz.pressure(x.back() * a) / p0);
  }
  x.push_back(shown);
  pressure.push_back(0);
  const point_contact::Grid& grid = spheres.solution.grid;
  for (Index j = 0; j < grid.n2; ++j) {
    for (Index i = 0; i < grid.n1; ++i) {
      const Vector2 at = grid.node(i, j);
      const double p = spheres.solution.pressure[grid.index(i, j)] / p0;
      const double error = std::abs(p - spheres.hertz.pressure(at.norm()) / p0);
      if (at.norm() < shown * a && error > 0) {
        r.push_back(at.norm() / a);
        difference.push_back(error);
      }
      if (j != grid.n2 / 2 || std::abs(at.x()) > shown * a) continue;
      row_x.push_back(at.x() / a);
      row_pressure.push_back(p);
    }
  }
  return {.width_cm = 15.4,
          .height_cm = 4.4,
          .data = {{"hertz", {{"x", x}, {"pressure", pressure}}},
                   {"row", {{"x", row_x}, {"pressure", row_pressure}}},
                   {"nodes", {{"r", r}, {"difference", difference}}},
                   {"base", lattice()},
                   {"pyramid", pyramid_at(0, 0)},
                   {"neighbour", pyramid_at(1, 0)}},
          .numbers = {{"shown", shown}}};
}

}  // namespace

Spheres solve_spheres(const ContactCase& c, const PointContactCase& p) {
  constexpr double share = 0.9;  // part of the square's half side that is in contact
  const double modulus = c.cylinders.contact_modulus();
  const double curvature = c.cylinders.relative_curvature();
  const point_contact::Hertz hertz(modulus, curvature, p.load);
  const point_contact::Problem problem{
      point_contact::Profile::paraboloid(curvature), modulus,
      point_contact::square_grid(2 * hertz.radius() / share, n_nodes),
      point_contact::Element::pyramid};
  return {hertz, point_contact::solve_for_load(problem, p.load, 1e-11)};
}

SphereErrors errors_of(const Spheres& spheres) {
  const auto& [hertz, solution] = spheres;
  const auto off = [](double number, double exact) { return std::abs(number / exact - 1); };
  const Vector2 semi_axes = solution.semi_axes();
  return {off(solution.peak_pressure(), hertz.peak_pressure()),
          off(std::sqrt(semi_axes[0] * semi_axes[1]), hertz.radius()),
          off(solution.approach, hertz.approach()),
          std::pow(solution.grid.spacing / hertz.radius(), 2)};
}

void compute_spheres(Document& document, const Case& from) {
  if (!from.point_contact) return;
  const ContactCase& c = from.contact;
  const UnitSystem& units = from.units;
  const Spheres spheres = solve_spheres(c, *from.point_contact);
  const auto& [hertz, solution] = spheres;
  const auto value = [&](const char* key, double number, const literate::Format& format,
                         const std::string& unit = "") {
    document.value(key, Value(number, format, unit).as_is());
  };
  document.value("spheres.load", Value(from.point_contact->load, exact(), units.force));
  value("spheres.radius", hertz.radius(), significant(4), units.length);
  value("spheres.peak", hertz.peak_pressure(), significant(4), units.stress);
  value("spheres.of-radius", hertz.radius() / least_radius(c), percent(1));
  value("spheres.elements", hertz.radius() / solution.grid.spacing, fixed(1));
  value("spheres.residual", solution.residuals.gap / hertz.approach(), scientific(1).rounded_up());
  document.value("spheres.nodes", Value(n_nodes, integer()));
  document.value("spheres.in-contact", Value(solution.n_in_contact(), integer()));
  document.value("spheres.products", Value(solution.work.products, integer()));
  document.figure("sphere-pressure", sphere_figure(spheres));
}

}  // namespace paper
