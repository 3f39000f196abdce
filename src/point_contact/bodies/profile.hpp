// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <limits>
#include <utility>

#include "point_contact/elements/lattice.hpp"

namespace point_contact {

/// The principal curvatures of a body's surface at the point of contact, reciprocals of lengths:
/// positive for a convex surface, 0 along a cylinder, negative for a hollow.
struct PrincipalCurvatures {
  double first;
  double second;
};

/// The gap between two bodies close to where they touch, h = (κ_x x² + κ_y y²)/2 in its own
/// principal axes.
struct RelativeCurvatures {
  double x;      ///< κ_x, the smaller: the contact is longest along x
  double y;      ///< κ_y
  double angle;  ///< from the first body's first principal direction to the x axis, radians
};

/// The relative curvatures of two bodies whose first principal directions stand at `angle`:
///
///   κ_x + κ_y = Σκ,  (κ_y − κ_x) = |Δ₁ + Δ₂ e^{2i angle}|,  Δ = first − second   (Johnson 4.3)
///
/// Throws InvalidQuantity unless both κ are positive: else the bodies touch along a line or at more
/// than one point.
RelativeCurvatures relative_curvatures(PrincipalCurvatures body1, PrincipalCurvatures body2,
                                       double angle);

/// The gap h(x, y) between two bodies that touch without load. Infinite where there is no body.
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

  /// h = (κ_x x² + κ_y y²)/2: principal relative curvatures > 0 along x and y (Johnson 4.3).
  static Profile elliptic_paraboloid(double curvature_x, double curvature_y);

  /// h = r tan α: a cone whose sides rise by `slope` = tan α > 0.
  static Profile cone(double slope);

  /// A rigid cylinder's flat end of this radius > 0: h = 0 on it, infinite beyond.
  static Profile flat_punch(double radius);

  /// h = κ(r − b)²/2 for r > b, else 0: a flat end of radius b ≥ 0, its edge rounded to the
  /// curvature κ > 0.
  static Profile rounded_punch(double flat_radius, double edge_curvature);

  /// h = A r^{2n}: A > 0 in length^{1−2n}, n from 1 to max_power.
  static Profile power_law(double coefficient, int n);
  static constexpr int max_power = 20;

  /// A measured surface: heights(i, j), the gap at x = (i − (n1−1)/2) spacing, y = (j − (n2−1)/2)
  /// spacing, at least four each way, joined by bicubic splines (GSL). Not defined beyond.
  static Profile height_map(const Eigen::ArrayXXd& heights, double spacing);

 private:
  using Gap = std::function<double(double, double)>;
  explicit Profile(Gap gap) : gap_(std::move(gap)) {}

  Gap gap_;
  Vector2 half_sides_ = Vector2::Constant(std::numeric_limits<double>::infinity());
};

/// A self-affine roughness: waves of random phases whose heights fall with the wave number.
struct Roughness {
  double rms;          ///< root mean square height, a length > 0
  int n_waves;         ///< of the shortest wave along a side, from 1 to max_waves
  double hurst;        ///< H, from 0 to 1: heights go with the wave number to the power −1−H
  std::uint64_t seed;  ///< another seed makes other phases
};

inline constexpr int max_waves = 64;

/// Heights on n × n points, n ≥ 2, that fill a square to its sides, opposite ones being the same:
///
///   h(x, y) = A Σ q^{−1−H} cos(2π(kx + ly) + φ_kl),  1 ≤ q² = k² + l² ≤ n_waves²,
///
/// x and y from 0 to 1, with one of (k, l) and (−k, −l), and A so that the mean square over the
/// square is rms². The phases are those of std::mt19937_64, which is the same everywhere. Throws
/// InvalidQuantity for values outside the ranges above.
Eigen::ArrayXXd rough_heights(const Roughness& roughness, Eigen::Index n);

}  // namespace point_contact
