// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

namespace numerics {

/// A smooth function on the closed interval [begin, end], begin < end.
///
/// At an end `value` is the limit from inside, so neighbours may disagree there: that is a jump.
struct Piece {
  double begin;
  double end;
  std::function<double(double)> value;
};

/// A function that is smooth on each of finitely many intervals and zero elsewhere.
///
/// The ends of the pieces are its only kinks and jumps; quadrature splits there.
class PiecewiseFunction {
 public:
  /// The function that is zero everywhere.
  PiecewiseFunction() = default;

  /// Pieces in rising order that may touch but not overlap; throws sys::InvalidQuantity otherwise.
  explicit PiecewiseFunction(std::vector<Piece> pieces);

  const std::vector<Piece>& pieces() const { return pieces_; }
  bool is_zero() const { return pieces_.empty(); }

  /// The function's value at s; at a jump the mean of the two limits, outside all pieces zero.
  double operator()(double s) const;

  /// The largest magnitude found at the ends and middles of the pieces: what tolerances refer to.
  double scale() const { return scale_; }

 private:
  std::vector<Piece> pieces_;
  double scale_ = 0;
};

/// The same function with pieces cut until each is nearly a polynomial, so that a quadrature that
/// samples every piece cannot miss a narrow feature between its samples.
///
/// Each piece is probed at 4096 places, spread evenly but for a part that varies (fewer if there
/// are many pieces, 65536 in all). It is cut in halves where a polynomial through 13 Chebyshev
/// points, or one of 25 in the angle that turns roots at the ends into sines, misses a probe by
/// more than 1e-12 of the greatest value. A part of 1/256 that still is not met has a kink, to
/// which it is cut down. A feature narrower than the distance of two probes may be missed.
PiecewiseFunction resolved(const PiecewiseFunction& function);

}  // namespace numerics
