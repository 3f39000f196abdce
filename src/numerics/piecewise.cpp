// SPDX-License-Identifier: GPL-3.0-or-later
#include "numerics/piecewise.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "system/require.hpp"

namespace numerics {

PiecewiseFunction::PiecewiseFunction(std::vector<Piece> pieces) : pieces_(std::move(pieces)) {
  double previous_end = -HUGE_VAL;
  for (const Piece& piece : pieces_) {
    sys::require_finite("begin of a piece", piece.begin);
    sys::require_finite("end of a piece", piece.end);
    if (piece.begin < previous_end) {
      throw sys::InvalidQuantity("begin of a piece", piece.begin,
                                 "at or beyond the end of the last one");
    }
    if (!(piece.begin < piece.end)) {
      throw sys::InvalidQuantity("end of a piece", piece.end, "greater than its begin");
    }
    previous_end = piece.end;
    const double middle = piece.begin + (piece.end - piece.begin) / 2;
    for (const double s : {piece.begin, middle, piece.end}) {
      scale_ = std::max(scale_, std::abs(sys::require_finite("value of a piece", piece.value(s))));
    }
  }
}

double PiecewiseFunction::operator()(double s) const {
  double from_left = 0;
  double from_right = 0;
  for (const Piece& piece : pieces_) {
    if (s > piece.begin && s < piece.end) return piece.value(s);
    if (s == piece.end) from_left = piece.value(s);
    if (s == piece.begin) from_right = piece.value(s);
  }
  return (from_left + from_right) / 2;
}

}  // namespace numerics
