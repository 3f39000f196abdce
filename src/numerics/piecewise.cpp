// SPDX-License-Identifier: GPL-3.0-or-later
#include "numerics/piecewise.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
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
                                 "at or beyond the end of the piece before it");
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

namespace {

struct Sample {
  double at;
  double value;
};
using Samples = std::vector<Sample>;

// Values of a piece at n places between begin and end, one in each of n equal cells. The position
// within the cell varies (fractional parts of multiples of the golden ratio), so that no periodic
// function escapes.
Samples probes_between(const Piece& piece, double begin, double end, std::size_t n) {
  Samples probes;
  probes.reserve(n);
  for (std::size_t i = 0; i < n; ++i) {
    const auto cell = static_cast<double>(i);
    const double turns = cell * std::numbers::phi;
    const double share = (cell + (turns - std::floor(turns))) / static_cast<double>(n);
    const double s = std::min(begin + share * (end - begin), end);
    probes.push_back({s, sys::require_finite("value of a piece", piece.value(s))});
  }
  return probes;
}

// The polynomial in v through the Chebyshev points of an interval, by the barycentric formula
// (Berrut & Trefethen 2004, SIAM Rev. 46, 501). v is the place itself or, for a function that
// begins or ends like a square root, the angle whose cosine is the place.
class Interpolant {
 public:
  enum class Variable { place, angle };

  Interpolant(const Piece& piece, double begin, double end, Variable variable, std::size_t n)
      : begin_(begin), length_(end - begin), variable_(variable) {
    for (std::size_t k = 0; k < n; ++k) {
      const double v =
          -std::cos(std::numbers::pi * static_cast<double>(k) / static_cast<double>(n - 1));
      const double share = variable == Variable::place
                               ? (1 + v) / 2
                               : std::pow(std::sin(std::numbers::pi * (1 + v) / 4), 2);
      points_.push_back({v, piece.value(begin + length_ * share)});
    }
  }

  double operator()(double s) const {
    const double share = std::clamp((s - begin_) / length_, 0.0, 1.0);
    const double v = variable_ == Variable::place
                         ? 2 * share - 1
                         : 4 * std::asin(std::sqrt(share)) / std::numbers::pi - 1;
    double numerator = 0;
    double denominator = 0;
    for (std::size_t k = 0; k < points_.size(); ++k) {
      if (v == points_[k].at) return points_[k].value;
      const bool is_end = k == 0 || k == points_.size() - 1;
      const double weight = (k % 2 == 0 ? 1 : -1) * (is_end ? 0.5 : 1);
      numerator += weight * points_[k].value / (v - points_[k].at);
      denominator += weight / (v - points_[k].at);
    }
    return numerator / denominator;
  }

 private:
  double begin_, length_;
  Variable variable_;
  Samples points_;
};

// Halves a piece until polynomials match all probes.
class Resolver {
 public:
  Resolver(const Piece& piece, double tolerance, std::vector<Piece>& parts)
      : piece_(piece), tolerance_(tolerance), parts_(parts) {}

  void cut(double begin, double end, std::span<const Sample> probes, int depth) {
    if (is_resolved(begin, end, probes)) return keep(begin, end);
    const double middle = begin + (end - begin) / 2;
    if (depth == most_halvings) return cut_at_kink(begin, end);
    const auto split =
        std::ranges::find_if(probes, [middle](const Sample& probe) { return probe.at >= middle; });
    const auto n_before = static_cast<std::size_t>(split - probes.begin());
    cut(begin, middle, probes.first(n_before), depth + 1);
    cut(middle, end, probes.subspan(n_before), depth + 1);
  }

 private:
  static constexpr int most_halvings = 8;

  // A part that is still unresolved contains a kink or a jump, across which QUADPACK's estimates
  // may be too small: halve down to it, though at no more than a few places, as noise would need.
  void cut_at_kink(double begin, double end) {
    if (begin == piece_.begin) return cut_towards(begin, end);
    if (end == piece_.end) return cut_towards(end, begin);
    cut_down(begin, end);
  }

  // At an end of the piece, rules that extrapolate handle a square root better in one piece. Halves
  // that shrink towards the end show whether there is a kink before it: no polynomial meets the
  // half with the kink.
  void cut_towards(double end, double far) {
    double outer = far;
    while (std::abs(end - outer) > shortest * length()) {
      const double middle = end + (outer - end) / 2;
      const double low = std::min(middle, outer);
      const double high = std::max(middle, outer);
      if (!is_resolved(low, high, probes_between(piece_, low, high, n_probes))) {
        keep(std::min(outer, far), std::max(outer, far));
        cut_down(low, high);
        return cut_towards(end, middle);
      }
      outer = middle;
    }
    keep(std::min(end, far), std::max(end, far));
  }

  void cut_down(double begin, double end) {
    if (n_kinks_ == most_kinks) return keep(begin, end);
    ++n_kinks_;
    cut_further(begin, end);
  }

  void cut_further(double begin, double end) {
    if (end - begin < shortest * length() ||
        is_resolved(begin, end, probes_between(piece_, begin, end, n_probes))) {
      return keep(begin, end);
    }
    const double middle = begin + (end - begin) / 2;
    cut_further(begin, middle);
    cut_further(middle, end);
  }

  // Whether a polynomial in the place or in the angle matches the probes.
  bool is_resolved(double begin, double end, std::span<const Sample> probes) const {
    const auto meets_all = [&](const Interpolant& polynomial) {
      return std::ranges::all_of(probes, [&](const Sample& probe) {
        return std::abs(polynomial(probe.at) - probe.value) <= tolerance_;
      });
    };
    return meets_all({piece_, begin, end, Interpolant::Variable::place, 13}) ||
           meets_all({piece_, begin, end, Interpolant::Variable::angle, 25});
  }

  void keep(double begin, double end) {
    if (begin < end) parts_.push_back({begin, end, piece_.value});
  }

  double length() const { return piece_.end - piece_.begin; }

  static constexpr double shortest = 1e-14;  // of the piece: the rounding of a place
  static constexpr std::size_t n_probes = 16;
  static constexpr int most_kinks = 8;
  const Piece& piece_;
  double tolerance_;
  std::vector<Piece>& parts_;
  int n_kinks_ = 0;
};

}  // namespace

PiecewiseFunction resolved(const PiecewiseFunction& function) {
  constexpr std::size_t most_probes = 65536;
  constexpr double negligible = 1e-12;
  std::vector<Samples> probes;
  double scale = function.scale();
  for (const Piece& piece : function.pieces()) {
    const std::size_t n = std::clamp<std::size_t>(most_probes / function.pieces().size(), 64, 4096);
    probes.push_back(probes_between(piece, piece.begin, piece.end, n));
    for (const Sample& probe : probes.back()) scale = std::max(scale, std::abs(probe.value));
  }
  std::vector<Piece> parts;
  for (std::size_t i = 0; i < probes.size(); ++i) {
    const Piece& piece = function.pieces()[i];
    Resolver(piece, negligible * scale, parts).cut(piece.begin, piece.end, probes[i], 0);
  }
  std::ranges::sort(parts, {}, &Piece::begin);
  return PiecewiseFunction(parts);
}

}  // namespace numerics
