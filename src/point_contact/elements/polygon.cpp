// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/elements/element.hpp"

#include <cstddef>

#include "point_contact/elements/patch.hpp"

namespace point_contact {

double uniform_potential(std::span<const Vector2> corners, const Vector2& at) {
  double sum = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    sum += edge_integrals(corners[i], corners[(i + 1) % corners.size()], at).angular;
  }
  return sum;
}

double linear_potential(const std::array<Vector2, 3>& corners, const std::array<double, 3>& values,
                        const Vector2& at) {
  double uniform = 0;
  Vector2 linear = Vector2::Zero();
  for (std::size_t i = 0; i < 3; ++i) {
    const EdgeIntegrals edge = edge_integrals(corners[i], corners[(i + 1) % 3], at);
    uniform += edge.angular;                    // ∫ dA/r
    linear += edge.first_moment * edge.normal;  // ∫ (Q−P)/r dA
  }

  // g from the rises of σ along two sides
  const Vector2 side1 = corners[1] - corners[0];
  const Vector2 side2 = corners[2] - corners[0];
  const double rise1 = values[1] - values[0];
  const double rise2 = values[2] - values[0];
  const Vector2 gradient =
      Vector2(rise1 * side2.y() - rise2 * side1.y(), rise2 * side1.x() - rise1 * side2.x()) /
      cross(side1, side2);
  return (values[0] + gradient.dot(at - corners[0])) * uniform + gradient.dot(linear);
}

}  // namespace point_contact
