// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/point_contact_figure.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace app {
namespace {

using point_contact::Vector2;

// The pressure at any point: that of the nearest node, 0 outside the grid.
class PressureAt {
 public:
  explicit PressureAt(const point_contact::Solution& solution) : solution_(solution) {}

  double operator()(const Vector2& at) const {
    const point_contact::Grid& grid = solution_.grid;
    const Vector2 from_centre = at - grid.centre;
    const auto j = static_cast<Eigen::Index>(
        std::llround(from_centre.y() / grid.between_rows().y() + middle(grid.n2)));
    if (j < 0 || j >= grid.n2) return 0;
    const auto i = static_cast<Eigen::Index>(
        std::llround(from_centre.x() / grid.lattice.first.x() + middle(grid.n1) - grid.shift(j)));
    if (i < 0 || i >= grid.n1) return 0;
    return solution_.pressure[grid.index(i, j)];
  }

 private:
  static double middle(Eigen::Index n) { return static_cast<double>(n - 1) / 2; }

  const point_contact::Solution& solution_;
};

// Half the sides of the rectangle about the origin that holds the contact, with a little room.
Vector2 half_sides_of(const point_contact::Solution& solution) {
  const point_contact::Grid& grid = solution.grid;
  Vector2 half = Vector2::Zero();
  for (Eigen::Index j = 0; j < grid.n2; ++j) {
    for (Eigen::Index i = 0; i < grid.n1; ++i) {
      if (solution.pressure[grid.index(i, j)] > 0) half = half.cwiseMax(grid.node(i, j).cwiseAbs());
    }
  }
  constexpr double room = 1.12;
  return room * half;
}

}  // namespace

literate::Figure point_contact_figure(const PointContactInput& input,
                                      const SolvedPointContact& solved,
                                      const config::UnitSystem& units) {
  const point_contact::Solution& s = solved.solution;
  const PressureAt pressure_at(s);
  const Vector2 half = half_sides_of(s);
  const auto coordinate = [](int i, int n, double half_side) {
    return half_side * (2.0 * i / (n - 1) - 1);
  };

  constexpr int n_across = 200;
  std::vector<double> x, y, pressure;
  for (int j = 0; j < n_across; ++j) {
    for (int i = 0; i < n_across; ++i) {
      const Vector2 at(coordinate(i, n_across, half.x()), coordinate(j, n_across, half.y()));
      x.push_back(at.x());
      y.push_back(at.y());
      pressure.push_back(pressure_at(at));
    }
  }
  literate::Figure figure{.width_cm = 20,
                          .height_cm = 9,
                          .data = {{"surface", {{"x", x}, {"y", y}, {"pressure", pressure}}}},
                          .numbers = {{"half_x", half.x()}, {"half_y", half.y()}},
                          .texts = {{"unit", units.length}, {"stress_unit", units.stress}}};

  for (const int axis : {0, 1}) {
    constexpr int n_along = 61;
    std::vector<double> along, values;
    for (int i = 0; i < n_along; ++i) {
      Vector2 at = Vector2::Zero();
      at[axis] = coordinate(i, n_along, half[axis]);
      along.push_back(at[axis]);
      values.push_back(pressure_at(at));
    }
    figure.data[axis == 0 ? "along_x" : "along_y"] = {{"s", along}, {"pressure", values}};
    if (!input.curvatures || !input.closed_form) continue;
    const double width =
        axis == 0 ? input.closed_form->half_width_x : input.closed_form->half_width_y;
    constexpr int n_exact = 401;
    along.clear();
    values.clear();
    for (int i = 0; i < n_exact; ++i) {
      along.push_back(coordinate(i, n_exact, half[axis]));
      const double share = along.back() / width;
      values.push_back(input.closed_form->peak_pressure *
                       std::sqrt(std::max(0.0, 1 - share * share)));
    }
    figure.data[axis == 0 ? "closed_x" : "closed_y"] = {{"s", along}, {"pressure", values}};
  }
  return figure;
}

}  // namespace app
