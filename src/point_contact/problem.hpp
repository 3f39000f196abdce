// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <limits>
#include <utility>

#include "point_contact/element.hpp"

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

/// Converts a non-negative count to the type of the standard library and FFTW.
inline std::size_t size_of(Eigen::Index n) {
  return static_cast<std::size_t>(n);
}

/// n1 × n2 nodes of a square lattice about the origin, each with an element.
///
/// A field on the grid is a vector of n2 rows of n1 values; node (i, j) is at index j n1 + i.
struct Grid {
  double spacing;   ///< c, a length
  Eigen::Index n1;  ///< nodes along x
  Eigen::Index n2;  ///< nodes along y

  Eigen::Index size() const { return n1 * n2; }
  Eigen::Index index(Eigen::Index i, Eigen::Index j) const { return j * n1 + i; }
  double cell_area() const { return spacing * spacing; }
  Vector2 node(Eigen::Index i, Eigen::Index j) const {
    return {(static_cast<double>(i) - static_cast<double>(n1 - 1) / 2) * spacing,
            (static_cast<double>(j) - static_cast<double>(n2 - 1) / 2) * spacing};
  }
};

/// The fewest and the most nodes along a side; the most take 7 GB.
inline constexpr Eigen::Index min_nodes = 8;
inline constexpr Eigen::Index max_nodes = 8192;

/// A grid of square cells with a node in the middle of each: n along the longer side of a
/// rectangle, and as many as fill the shorter side. Throws InvalidQuantity for a side that is not >
/// 0 and for n outside [min_nodes, max_nodes].
Grid rectangular_grid(double width, double height, Eigen::Index n);

/// n × n nodes that fill a square. Throws what rectangular_grid throws.
Grid square_grid(double width, Eigen::Index n);

/// Two bodies to be pressed together, and the elements that represent their pressure.
struct Problem {
  Profile profile;
  double contact_modulus;  ///< E*, a stress
  Grid grid;
  Element element = Element::pyramid;
};

/// h at the nodes. Throws InvalidQuantity unless E* > 0, the grid has min_nodes to max_nodes per
/// side and lies within a measured surface, and all gaps are less than contact::largest_length.
Eigen::VectorXd initial_gaps(const Problem& problem);

/// Σφ = P/(πE*c) for the load P, with nodal loads φ = c p/(πE*); a length. Throws InvalidQuantity
/// for P ≤ 0 and if Σφ is not less than contact::largest_length.
double total_phi(const Problem& problem, double load);

}  // namespace point_contact
