// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/study/two_spheres.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "point_contact/closed_forms/spheres.hpp"
#include "point_contact/solver/methods.hpp"
#include "point_contact/solver/solution.hpp"

namespace point_contact {
namespace {

using Eigen::Index;

// The part of the contact's radius within which errors are those of a smooth pressure.
constexpr double inner_part = 0.8;

// The stresses of an axially symmetric state at a place, in the coordinates x, y, z.
Eigen::Matrix3d turned(const AxialStress& s, const Vector2& at) {
  const Vector2 radial = at.normalized();
  const Vector2 around(-radial.y(), radial.x());
  Eigen::Matrix3d stress = Eigen::Matrix3d::Zero();
  stress.topLeftCorner<2, 2>() =
      s.rr * radial * radial.transpose() + s.tt * around * around.transpose();
  stress.topRightCorner<2, 1>() = s.rz * radial;
  stress.bottomLeftCorner<1, 2>() = s.rz * radial.transpose();
  stress(2, 2) = s.zz;
  return stress;
}

// Eight places beside nodes, spread over the disk by the golden angle.
std::vector<Vector2> places_between_nodes(const Grid& grid, double radius) {
  constexpr int n_places = 8;
  constexpr std::array<std::array<double, 2>, 4> beside = {
      {{0.125, 0.375}, {0.375, -0.125}, {-0.125, -0.375}, {-0.375, 0.125}}};
  const double turn = std::numbers::pi * (3 - std::sqrt(5.0));
  const double middle1 = static_cast<double>(grid.n1 - 1) / 2;
  const double middle2 = static_cast<double>(grid.n2 - 1) / 2;
  std::vector<Vector2> places;
  for (int k = 0; k < n_places; ++k) {
    // The middle of rings of equal area; the offsets stay within the disk on all but coarse grids.
    const double r = radius * std::sqrt((k + 0.5) / n_places);
    const Vector2 at(r * std::cos(k * turn), r * std::sin(k * turn));
    const auto j = std::llround((at.y() - grid.centre.y()) / grid.between_rows().y() + middle2);
    const auto i =
        std::llround((at.x() - grid.centre.x()) / grid.lattice.first.x() + middle1 - grid.shift(j));
    const auto& [u, v] = beside[static_cast<std::size_t>(k) % beside.size()];
    places.emplace_back(grid.node(i, j) + u * grid.lattice.first + v * grid.lattice.second);
  }
  return places;
}

}  // namespace

Solution solve_spheres(const TwoSpheres& spheres, Element element, Index n, double more) {
  constexpr double share = 0.9;  // of the square's half side that is in contact
  constexpr double tolerance = 1e-11;
  const double over_radius = share * static_cast<double>(n) / 2;
  const double width = 2 * spheres.hertz().radius() / share * over_radius / (over_radius + more);
  return solve_for_load(
      {Profile::paraboloid(spheres.relative_curvature), spheres.contact_modulus,
       element == Element::pyramid ? hexagonal_grid(width, n) : square_grid(width, n), element},
      spheres.load, {.tolerance = tolerance});
}

PressureErrors pressure_errors(const TwoSpheres& spheres, const Solution& solution) {
  const Hertz hertz = spheres.hertz();
  const Grid& grid = solution.grid;
  const double a = hertz.radius();
  const double p0 = hertz.peak_pressure();
  double squares = 0;
  double largest = 0;
  int n_inside = 0;
  for (Index j = 0; j < grid.n2; ++j) {
    for (Index i = 0; i < grid.n1; ++i) {
      const double r = grid.node(i, j).norm();
      const double error = (solution.pressure[grid.index(i, j)] - hertz.pressure(r)) / p0;
      largest = std::max(largest, std::abs(error));
      if (r > inner_part * a) continue;
      squares += error * error;
      ++n_inside;
    }
  }
  const Vector2 semi_axes = solution.semi_axes();
  return {.elements = a / grid.spacing(),
          .inside = std::sqrt(squares / n_inside),
          .largest = largest,
          .peak = solution.peak_pressure() / p0 - 1,
          .radius_by_area = std::sqrt(solution.contact_area() / std::numbers::pi) / a - 1,
          .radius = std::sqrt(semi_axes[0] * semi_axes[1]) / a - 1,
          .approach = solution.approach / hertz.approach() - 1};
}

SurfaceErrors surface_errors(const TwoSpheres& spheres, const elasticity::Material& material,
                             const Solution& solution) {
  const Hertz hertz = spheres.hertz();
  const Huber huber(hertz, material.poisson());
  const double depth = solution.grid.spacing() / 2;
  const double edge_slope = spheres.relative_curvature * hertz.radius();
  const std::vector<Vector2> places =
      places_between_nodes(solution.grid, inner_part * hertz.radius());
  double slopes = 0;
  double stresses = 0;
  for (const Vector2& at : places) {
    const Vector2 slope = slope_of_surface(solution, spheres.contact_modulus, at);
    const Eigen::Matrix3d stress =
        field_beneath(solution, material, {at.x(), at.y(), depth}).stress;
    slopes += (slope + spheres.relative_curvature * at).squaredNorm();
    stresses += (stress - turned(huber.stress(at.norm(), depth), at)).squaredNorm();
  }
  const auto n = static_cast<double>(places.size());
  return {.slope = std::sqrt(slopes / n) / edge_slope,
          .stress = std::sqrt(stresses / n) / hertz.peak_pressure()};
}

double pressure_bound(const Solution& solution) {
  const auto n = static_cast<double>(solution.grid.n1);
  return 4 * solution.residuals.pressure / solution.peak_pressure() +
         16 * std::numeric_limits<double>::epsilon() * n;
}

namespace {

// The root mean squares of what is added to them.
class RootMeanSquare {
 public:
  void add(double error) { squares_ += error * error; }
  double over(int n) const { return std::sqrt(squares_ / n); }

 private:
  double squares_ = 0;
};

}  // namespace

ElementStudy study_element(const TwoSpheres& spheres, const elasticity::Material& material,
                           Element element) {
  constexpr int n_places = n_study_places;
  constexpr std::array n_nodes = {Index{36}, Index{44}, Index{54},
                                  Index{66}, Index{82}, Index{102}};
  ElementStudy study;
  for (const Index n : n_nodes) {
    RootMeanSquare inside, largest, peak, by_area, radius, approach, slope, stress;
    double logarithms = 0;
    double bound = 0;
    for (int k = 0; k < n_places; ++k) {
      const Solution solution =
          solve_spheres(spheres, element, n, static_cast<double>(k) / n_places);
      const PressureErrors e = pressure_errors(spheres, solution);
      logarithms += std::log(e.elements);
      inside.add(e.inside);
      largest.add(e.largest);
      peak.add(e.peak);
      by_area.add(e.radius_by_area);
      radius.add(e.radius);
      approach.add(e.approach);
      bound = std::max(bound, pressure_bound(solution));
      const SurfaceErrors s = surface_errors(spheres, material, solution);
      slope.add(s.slope);
      stress.add(s.stress);
    }
    study.elements.push_back(std::exp(logarithms / n_places));
    study.inside.push_back(inside.over(n_places));
    study.largest.push_back(largest.over(n_places));
    study.peak.push_back(peak.over(n_places));
    study.radius_by_area.push_back(by_area.over(n_places));
    study.radius.push_back(radius.over(n_places));
    study.approach.push_back(approach.over(n_places));
    study.bound.push_back(bound);
    study.slope.push_back(slope.over(n_places));
    study.stress.push_back(stress.over(n_places));
  }
  return study;
}

}  // namespace point_contact
