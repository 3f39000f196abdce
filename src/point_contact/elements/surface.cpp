// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/elements/surface.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "point_contact/elements/polygon.hpp"

namespace point_contact {
namespace {

// One end of an edge: the primitives of ln(r/l) and s ln(r/l), r² = h² + s², at its coordinate s.
struct LogarithmAt {
  double of_log;
  double of_s_log;

  LogarithmAt(double s, double h, double length) {
    const double r = std::hypot(s, h);
    const double log = r == 0 ? 0 : std::log(r / length);  // its factors are then 0
    of_log = s * (log - 1) + (h == 0 ? 0 : h * std::atan(s / h));
    of_s_log = r * r * (log / 2 - 0.25);
  }
};

}  // namespace

Eigen::Vector3d surface_displacement(const std::array<Vector2, 3>& corners,
                                     const std::array<double, 3>& values,
                                     const elasticity::Material& material, const Vector2& at) {
  const Vector2 side1 = corners[1] - corners[0];
  const Vector2 side2 = corners[2] - corners[0];
  const double rise1 = values[1] - values[0];
  const double rise2 = values[2] - values[0];
  const Vector2 g =
      Vector2(rise1 * side2.y() - rise2 * side1.y(), rise2 * side1.x() - rise1 * side2.x()) /
      cross(side1, side2);
  const double value = values[0] + g.dot(at - corners[0]);

  // The unit of the logarithm changes nothing; the farthest corner makes it small.
  double length = 0;
  for (const Vector2& corner : corners) length = std::max(length, (corner - at).norm());

  double area_log = 0;                 // ∫ ln r dA
  Vector2 edge_log = Vector2::Zero();  // Σ n ∫ p ln r ds
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector2 to_begin = corners[k] - at;
    const Vector2 to_end = corners[(k + 1) % 3] - at;
    const Vector2 tangent = (to_end - to_begin).normalized();
    const Vector2 normal(tangent.y(), -tangent.x());
    const double h = (to_begin.norm() < to_end.norm() ? to_begin : to_end).dot(normal);
    const double s1 = to_begin.dot(tangent);
    const double s2 = to_end.dot(tangent);
    const LogarithmAt begin(s1, h, length);
    const LogarithmAt end(s2, h, length);
    const double log = end.of_log - begin.of_log;
    const double s_log = end.of_s_log - begin.of_s_log;
    area_log += h * (log - (s2 - s1) / 2) / 2;
    edge_log += normal * ((value + h * g.dot(normal)) * log + g.dot(tangent) * s_log);
  }
  const Vector2 tangential =
      -material.local_compliance() / (2 * std::numbers::pi) * (g * area_log - edge_log);
  const double normal = material.integral_compliance() / 2 * linear_potential(corners, values, at);
  return {tangential.x(), tangential.y(), normal};
}

}  // namespace point_contact
