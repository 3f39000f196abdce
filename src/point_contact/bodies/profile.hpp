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
/// Copies share only immutable data. x, y and h are lengths.
class Profile {
 public:
  double gap(const Vector2& at) const { return gap_(at.x(), at.y()); }

  /// The half sides of the profile's domain, a rectangle about the origin; infinite for a formula.
  const Vector2& half_sides() const { return half_sides_; }

  /// h = κ(x² + y²)/2: two spheres, κ = 1/R₁ + 1/R₂ > 0 (Johnson 4.17).
  static Profile paraboloid(double relative_curvature);

  /// h = (κ_x x² + κ_y y²)/2 with the principal relative curvatures along x and y, each > 0 and the
  /// sum of both bodies' curvatures (Johnson 4.3).
  static Profile elliptic_paraboloid(double curvature_x, double curvature_y);

  /// A measured surface: heights(i, j) is the gap at x = (i − (n1−1)/2) spacing, y = (j − (n2−1)/2)
  /// spacing, with at least four points each way, interpolated by bicubic splines (GSL). Undefined
  /// beyond. Throws InvalidQuantity for fewer points, a spacing ≤ 0 and heights that are not
  /// finite.
  static Profile height_map(const Eigen::ArrayXXd& heights, double spacing);

 private:
  using Gap = std::function<double(double, double)>;
  explicit Profile(Gap gap) : gap_(std::move(gap)) {}

  Gap gap_;
  Vector2 half_sides_ = Vector2::Constant(std::numeric_limits<double>::infinity());
};

}  // namespace point_contact
