// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

namespace numerics {

/// A smooth function on the closed interval [begin, end], begin < end.
///
/// At an end, `value` is the limit from inside. Neighbours that disagree there make a jump.
struct Piece {
  double begin;
  double end;
  std::function<double(double)> value;
};

/// A function that is smooth on each of finitely many intervals and zero elsewhere.
///
/// The ends of the pieces are its only kinks and jumps; quadrature splits the interval there.
class PiecewiseFunction {
 public:
  /// The function that is zero everywhere.
  PiecewiseFunction() = default;

  /// The pieces are in rising order and may touch but not overlap; throws sys::InvalidQuantity
  /// otherwise.
  explicit PiecewiseFunction(std::vector<Piece> pieces);

  const std::vector<Piece>& pieces() const { return pieces_; }
  bool is_zero() const { return pieces_.empty(); }

  /// The function's value at s: the mean of the two limits at a jump, zero outside all pieces.
  double operator()(double s) const;

  /// The largest magnitude at the ends and middles of the pieces, to which tolerances refer.
  double scale() const { return scale_; }

 private:
  std::vector<Piece> pieces_;
  double scale_ = 0;
};

/// The same function, cut into pieces that are each nearly a polynomial, so that a quadrature
/// cannot miss a narrow feature between its abscissae.
///
/// Each piece is sampled at 4096 nearly even places (fewer if there are many pieces, 65536 in all).
/// A part is halved until a polynomial matches its samples to 1e-12 of the greatest value: one
/// through 13 Chebyshev points in s, or one through 25 in an angle that turns square roots at the
/// ends into sines. A part of 1/256 that still does not match contains a kink, and is halved down
/// to it. A feature narrower than the distance between two samples may be missed.
PiecewiseFunction resolved(const PiecewiseFunction& function);

}  // namespace numerics
