// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "numerics/estimate.hpp"
#include "numerics/piecewise.hpp"
#include "numerics/quadrature.hpp"

namespace numerics {

/// Integrals of a piecewise smooth density p(s) against the kernels of plane elasticity.
///
/// Accuracy: the absolute tolerance of each piece's quadrature is `rel_tolerance` times the scale
/// of p (times the piece's length where the result is p times a length); the reported error adds
/// the rounding. It is pessimistic by several orders of magnitude where p is a polynomial, for
/// which the rules are exact. Throws QuadratureError where a quadrature fails. Not thread-safe.
class KernelIntegrals {
 public:
  explicit KernelIntegrals(const PiecewiseFunction& density, double rel_tolerance = 1e-12);

  /// PV∫ p(s)/(x − s) ds, a Cauchy principal value where x lies under p.
  ///
  /// On each piece, the value c of p at the point nearest to x is split off; its integral is
  /// c·ln|(x − begin)/(x − end)|, and QAWC integrates the rest. The logarithms that two
  /// neighbouring pieces share at a kink therefore cancel before any rounding, and x may lie at a
  /// kink or arbitrarily near it. Throws sys::InvalidQuantity at a jump of p, where the integral is
  /// infinite.
  Estimate cauchy(double x) const;

  /// ∫ p(s) ln(|x − s|/length) ds, length > 0 in the unit of s; any finite x.
  ///
  /// Near x the substitution |x − s| ∝ y⁴ makes the logarithm smooth, and the value of p at the
  /// point nearest to x is split off as above.
  Estimate logarithmic(double x, double length) const;

  /// ∫ p(s) ds over s < x.
  Estimate integral_below(double x) const;

  /// ∫ p(s) ds.
  Estimate total() const;

 private:
  Estimate cauchy_regular_part(const Piece& piece, double nearest_value, double x) const;

  // The part of a piece on one side of x: from its near end, at `distance` from x, to its far end.
  struct Panel {
    const std::function<double(double)>& value;
    double near_end;
    double far_end;
    double distance;
  };
  Estimate logarithmic_from(const Panel& panel, double x, double length) const;

  PiecewiseFunction density_;  // cut into pieces that the quadrature rules resolve
  double rel_tolerance_;
  mutable Quadrature quadrature_;
};

}  // namespace numerics
