// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include "line_contact/element.hpp"

namespace line_contact {

/// The gap h(x) between two bodies that touch without load: h of the paper's eqs. (1a) and (1b).
///
/// Copies share only immutable data. x and h are lengths.
class Profile {
 public:
  /// h(x).
  double gap(double x) const { return gap_(x); }

  /// h(to) − h(from), accurate to its own rounding where the formula allows it: on a fine grid,
  /// subtracting two gaps would leave few digits.
  double rise(double from, double to) const { return rise_(from, to); }

  /// The ends of the profile's domain; infinite for a formula.
  double begin() const { return begin_; }
  double end() const { return end_; }

  /// h = κx²/2: two cylinders, κ = 1/R₁ + 1/R₂ > 0 (Johnson 4.19).
  static Profile parabola(double relative_curvature);

  /// A measured profile: h at four or more rising x, interpolated by Steffen's monotone cubics
  /// (once differentiable, no overshoot; GSL). Undefined beyond the points. Throws InvalidQuantity
  /// for fewer points, x that do not rise, and numbers that are not finite.
  static Profile tabulated(const std::vector<double>& x, const std::vector<double>& gap);

 private:
  using Gap = std::function<double(double)>;
  using Rise = std::function<double(double, double)>;
  Profile(Gap gap, Rise rise) : gap_(std::move(gap)), rise_(std::move(rise)) {}

  Gap gap_;
  Rise rise_;
  double begin_ = -std::numeric_limits<double>::infinity();
  double end_ = std::numeric_limits<double>::infinity();
};

/// Evenly spaced nodes about a centre, each with an element.
///
/// Triangles of half-width `spacing` (Fig. 2 of the paper) make the pressure linear between nodes.
struct Grid {
  Eigen::Index n_nodes;
  double spacing;     ///< c, a length
  double centre = 0;  ///< x midway between the end nodes

  double x(Eigen::Index i) const {
    return centre + (static_cast<double>(i) - static_cast<double>(n_nodes - 1) / 2) * spacing;
  }
  Eigen::VectorXd nodes() const;

  /// The ends of the domain, half a spacing beyond the end nodes.
  double begin() const { return x(0) - spacing / 2; }
  double end() const { return x(n_nodes - 1) + spacing / 2; }
  double width() const { return static_cast<double>(n_nodes) * spacing; }
};

/// The fewest nodes that allow a contact with a free node on either side, and the most of any
/// method, at 90 bytes per node. The dense methods take fewer (contact::max_dense_nodes).
inline constexpr Eigen::Index min_nodes = 10;
inline constexpr Eigen::Index max_nodes = Eigen::Index{1} << 24;

/// A grid of n_nodes that extends beyond a contact of the expected half-width by a tenth of it and
/// one spacing on either side. Throws InvalidQuantity for n_nodes outside [min_nodes, max_nodes]
/// and a half_width that is not > 0.
Grid grid_around(double half_width, Eigen::Index n_nodes);

/// n_nodes in the middles of n_nodes spacings that together fill `width` about `centre`. Throws
/// what grid_around throws.
Grid grid_of_width(double width, Eigen::Index n_nodes, double centre = 0);

/// Two bodies to be pressed together, and the elements that represent their pressure.
///
/// Where the bodies touch, u_z1 + u_z2 + h = δ and p ≥ 0. This is eq. (1a) of the paper.
/// Elsewhere u_z1 + u_z2 + h > δ and p = 0. This is eq. (1b) of the paper.
struct Problem {
  Profile profile;
  double contact_modulus;  ///< E*, a stress
  Grid grid;
  Element element = Element::triangular;
};

/// Throws InvalidQuantity unless E* > 0, the grid lies within a measured profile, all gaps are less
/// than contact::largest_length, and the greatest gap is 0 or at least 1e-130, so that its square
/// does not underflow.
void require_valid(const Problem& problem);

}  // namespace line_contact
