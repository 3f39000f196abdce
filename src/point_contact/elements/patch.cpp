// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/elements/patch.hpp"

#include <algorithm>

namespace point_contact {

Patch::Patch(std::span<const Vector2> corners, double value)
    : n_corners_(corners.size()),
      at_first_corner_{value, Vector2::Zero(), Eigen::Matrix2d::Zero()} {
  std::ranges::copy(corners, corners_.begin());
}

Patch Patch::triangle(const std::array<Vector2, 3>& corners, const std::array<double, 3>& values) {
  Patch patch(corners, values[0]);
  const Vector2 side1 = corners[1] - corners[0];
  const Vector2 side2 = corners[2] - corners[0];
  const double rise1 = values[1] - values[0];
  const double rise2 = values[2] - values[0];
  patch.at_first_corner_.gradient =
      Vector2(rise1 * side2.y() - rise2 * side1.y(), rise2 * side1.x() - rise1 * side2.x()) /
      cross(side1, side2);
  return patch;
}

Patch Patch::uniform(const std::array<Vector2, 4>& corners, double value) {
  return {corners, value};
}

Patch Patch::bilinear(const std::array<Vector2, 4>& corners, const std::array<double, 4>& values) {
  Patch patch(corners, values[0]);
  const Vector2 side1 = corners[1] - corners[0];
  const Vector2 side2 = corners[3] - corners[0];
  const Vector2 along1 = side1 / side1.squaredNorm();
  const Vector2 along2 = side2 / side2.squaredNorm();
  const double twist = values[0] - values[1] + values[2] - values[3];
  patch.at_first_corner_.gradient =
      (values[1] - values[0]) * along1 + (values[3] - values[0]) * along2;
  patch.at_first_corner_.hessian =
      twist * (along1 * along2.transpose() + along2 * along1.transpose());
  return patch;
}

Patch::Expansion Patch::about(const Vector2& at) const {
  const auto& [value, gradient, hessian] = at_first_corner_;
  const Vector2 d = at - corners_[0];
  const Vector2 bent = hessian * d;
  return {value + gradient.dot(d) + d.dot(bent) / 2, gradient + bent, hessian};
}

}  // namespace point_contact
