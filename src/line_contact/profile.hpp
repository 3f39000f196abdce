// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <limits>
#include <utility>
#include <vector>

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

}  // namespace line_contact
