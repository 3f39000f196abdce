// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "numerics/estimate.hpp"
#include "numerics/piecewise.hpp"
#include "numerics/quadrature.hpp"

namespace numerics {

/// Integrals of a piecewise smooth density p(s) against the kernels of plane elasticity.
///
/// Accuracy: `rel_tolerance` times the scale of p (and, where the result is a p times a length, the
/// length of each piece) is asked of each piece's quadrature; the reported error adds the rounding.
/// The estimate is pessimistic by several orders where p is a polynomial, for which the rules are
/// exact. Throws QuadratureError where a quadrature fails. Not for use by two threads at once.
class KernelIntegrals {
 public:
  explicit KernelIntegrals(const PiecewiseFunction& density, double rel_tolerance = 1e-12);

  /// p, cut into pieces that the quadratures resolve (numerics::resolved).
  const PiecewiseFunction& density() const { return density_; }

  /// PV∫ p(s)/(x − s) ds, a Cauchy principal value where x lies under p.
  ///
  /// On each piece p's value c at the point nearest to x is split off, for which the integral is
  /// c·ln|(x − begin)/(x − end)|; QAWC takes the rest. So the logarithms that two neighbouring
  /// pieces have in common at a kink cancel before any rounding, and x may lie at a kink or as near
  /// to it as one likes. Throws sys::InvalidQuantity at a jump of p, where the integral is
  /// infinite.
  Estimate cauchy(double x) const;

  /// ∫ p(s) ln(|x − s|/length) ds, length > 0 in the unit of s; any finite x.
  ///
  /// The variable is t⁴ ∝ |x − s| where x is near, which makes the logarithm smooth, and p's value
  /// at the point nearest to x is split off as above.
  Estimate logarithmic(double x, double length) const;

  /// ∫ p(s) ds over s < x.
  Estimate integral_below(double x) const;

  /// ∫ p(s) ds.
  Estimate total() const;

 private:
  Estimate cauchy_regular_part(const Piece& piece, double nearest_value, double x) const;

  // A part of a piece on one side of x: from its end near x, `distance` away, to its far end.
  struct Panel {
    const std::function<double(double)>& value;
    double near_end;
    double far_end;
    double distance;
  };
  Estimate logarithmic_from(const Panel& panel, double x, double length) const;

  PiecewiseFunction density_;
  double rel_tolerance_;
  mutable Quadrature quadrature_;
};

}  // namespace numerics
