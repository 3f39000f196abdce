// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <functional>
#include <limits>
#include <utility>

#include "point_contact/elements/edge.hpp"

namespace point_contact {

/// The gap h(x, y) between two bodies that touch without load.
///
/// A value; copies share nothing that changes. x, y and h are lengths.
class Profile {
 public:
  double gap(const Vector2& at) const { return gap_(at.x(), at.y()); }

  /// The half sides of the rectangle about the origin where the profile is given; infinite for a
  /// formula.
  const Vector2& half_sides() const { return half_sides_; }

  /// h = κ(x² + y²)/2: two spheres, κ = 1/R₁ + 1/R₂ > 0 (Johnson 4.17).
  static Profile paraboloid(double relative_curvature);

  /// h = (κ_x x² + κ_y y²)/2: principal relative curvatures > 0 along x and y, each the sum of both
  /// bodies' (Johnson 4.3).
  static Profile elliptic_paraboloid(double curvature_x, double curvature_y);

  /// A measured surface: heights(i, j), the gap at x = (i − (n1−1)/2) spacing, y = (j − (n2−1)/2)
  /// spacing, at least four each way, joined by bicubic splines (GSL). Not defined beyond.
  static Profile height_map(const Eigen::ArrayXXd& heights, double spacing);

 private:
  using Gap = std::function<double(double, double)>;
  explicit Profile(Gap gap) : gap_(std::move(gap)) {}

  Gap gap_;
  Vector2 half_sides_ = Vector2::Constant(std::numeric_limits<double>::infinity());
};

}  // namespace point_contact
