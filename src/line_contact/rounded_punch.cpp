// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_contact/rounded_punch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "system/require.hpp"

namespace line_contact {
namespace {

// Σ z^{k−1}/(2k+1), k = 1, 2, …: (artanh y − y)/y³ at z = y², (y − arctan y)/y³ at z = −y².
double odd_tail(double z) {
  double sum = 0;
  double power = 1;
  for (int k = 1; std::abs(power) > std::numeric_limits<double>::epsilon(); ++k) {
    sum += power / (2 * k + 1);
    power *= z;
  }
  return sum;
}

// Below this square of a ratio the tails' series take over, with 16 terms at most; above it the
// closed forms lose a factor 30 by cancellation at most.
constexpr double small_squared = 0.1;

// a²ψ − b w = 2P/(E*κ) as a function of w: convex and rising, with the derivative 2wψ.
double scaled_load(double w, double b) {
  if (w * w < small_squared * b * b) {
    const double squared = (w / b) * (w / b);
    return w * w * (w / b) * (1 - (1 + squared) * odd_tail(-squared));
  }
  return (b * b + w * w) * std::atan2(w, b) - b * w;
}

// Its root, by Newton's method from above. The roots for b → 0 and for a → b are too small, their
// sum is too large for every b; from there, a²ψ − b w being convex, the iterates fall until
// rounding stops them.
double find_chord(double b, double load) {
  double w = std::sqrt(2 * load / std::numbers::pi) + std::cbrt(1.5 * load * b);
  for (;;) {
    const double next = w - (scaled_load(w, b) - load) / (2 * w * std::atan2(w, b));
    if (!(next < w)) return w;
    w = next;
  }
}

double checked_flat(double b) {
  if (sys::require_finite("flat_half_width", b) < 0) {
    throw sys::InvalidQuantity("flat_half_width", b, "0 or greater");
  }
  return b;
}

}  // namespace

RoundedPunch::RoundedPunch(double contact_modulus, double flat_half_width, double edge_curvature,
                           double line_load)
    : flat_half_width_(checked_flat(flat_half_width)),
      edge_curvature_(sys::require_positive("edge_curvature", edge_curvature)),
      line_load_(sys::require_positive("load", line_load)),
      pressure_scale_(sys::require_positive("contact_modulus", contact_modulus) * edge_curvature /
                      std::numbers::pi),
      chord_(find_chord(flat_half_width, 2 * line_load / (contact_modulus * edge_curvature))),
      half_width_(std::hypot(flat_half_width, chord_)),
      overhang_(chord_ * (chord_ / (half_width_ + flat_half_width))),
      angle_(std::atan2(chord_, flat_half_width)) {}

double RoundedPunch::edge_curvature_for(double contact_modulus, double flat_half_width,
                                        double half_width, double line_load) {
  const double b = checked_flat(flat_half_width);
  const double a = sys::require_finite("half_width", half_width);
  if (!(a > b)) throw sys::InvalidQuantity("half_width", a, "greater than that of the flat");
  const double angle = std::acos(b / a);
  return 2 * sys::require_positive("load", line_load) /
         (sys::require_positive("contact_modulus", contact_modulus) *
          (a * a * angle - b * std::sqrt(a * a - b * b)));
}

// a − x, from a or from a − b, whichever has the digits; the edge is where half_width() says,
// unless that was rounded to b.
double RoundedPunch::to_edge(double x) const {
  if (x == half_width_ && x > flat_half_width_) return 0;
  return 2 * flat_half_width_ < half_width_ ? half_width_ - x : overhang_ - (x - flat_half_width_);
}

double RoundedPunch::pressure(double x) const {
  x = std::abs(x);
  if (!(to_edge(x) > 0)) return 0;
  const double b = flat_half_width_;
  const double r = std::sqrt(to_edge(x) * (half_width_ + x));
  return x < b ? pressure_under_flat(x, r) : pressure_beyond_flat(x - b, r);
}

double RoundedPunch::pressure_beyond_flat(double distance, double r) const {
  const double a = half_width_;
  const double b = flat_half_width_;
  if (b == 0) return pressure_scale_ * angle_ * r;  // Hertz
  const double x = b + distance;
  const double root = std::sqrt(distance * (x + b));
  const double kink = distance == 0 ? 0 : distance * std::asinh(b * r / (a * root));
  const double flat = b * std::asinh(chord_ * r / (a * (b + x)));
  return pressure_scale_ * (angle_ * r + kink - flat);
}

double RoundedPunch::pressure_under_flat(double x, double r) const {
  const double a = half_width_;
  const double b = flat_half_width_;
  const double w = chord_;
  if (w * w >= small_squared * r * r) {
    const double kink = (b - x) * std::asinh(x * w / (a * std::sqrt((b - x) * (b + x))));
    return pressure_scale_ * (angle_ * r - kink - b * std::asinh(w * r / (a * (b + x))));
  }
  // Split arctan τ = ψ, artanh m and artanh q, to which the arsinh are equal, into their arguments,
  // whose sum is the first term, and their tails: all that remains is of the order w³.
  const double square = a * a + b * x;
  const double tau = w / b;
  const double m = x / (b * r) * w;
  const double q = r / square * w;
  const auto cube = [](double y) { return y * y * y; };
  const double sum = a * a / (b * r * square) - r / cube(b) * odd_tail(-tau * tau) -
                     (b - x) * cube(m / w) * odd_tail(m * m) - b * cube(q / w) * odd_tail(q * q);
  return pressure_scale_ * cube(w) * sum;
}

double RoundedPunch::peak_pressure() const {
  // Between b and a, p' ∝ arsinh(br/(a√(x²−b²))) − ψx/r falls from ∞ to −∞, and p is flat at the
  // root, so that bisection to 1e-9 of a − b gives all digits of p.
  const double b = flat_half_width_;
  const auto r = [&](double distance) {
    return std::sqrt((overhang_ - distance) * (half_width_ + b + distance));
  };
  double low = 0;
  double high = overhang_;
  while (high - low > 1e-9 * overhang_) {
    const double distance = (low + high) / 2;
    const double x = b + distance;
    const double root = std::sqrt(distance * (x + b));
    const double rise = std::asinh(b * r(distance) / (half_width_ * root));
    (rise > angle_ * x / r(distance) ? low : high) = distance;
  }
  return pressure_beyond_flat(low, r(low));
}

double RoundedPunch::gap(double x) const {
  x = std::abs(x);
  if (!(to_edge(x) < 0)) return 0;
  const double a = half_width_;
  const double b = flat_half_width_;
  const double w = chord_;
  const double R = std::sqrt(-to_edge(x) * (x + a));
  const double square = a * a + b * x;
  const double q = w * R / square;
  double sum = (x - b) * (x - b) * std::atan2(b * R, x * w) - scaled_load(w, b) * std::asinh(R / a);
  if (w * w >= small_squared * b * b) {
    sum += x * R * angle_ - 2 * b * x * std::atan(q);
  } else {
    // The same with ψ = arctan τ and arctan q split into arguments, the first term, and tails
    const double tau = w / b;
    sum += x * R * w * (w * w + b * (x - b)) / (b * square) -
           x * R * tau * tau * tau * odd_tail(-tau * tau) +
           2 * b * x * q * q * q * odd_tail(-q * q);
  }
  // beside the edge, rounding may leave less than 0
  return std::max(0.0, edge_curvature_ / std::numbers::pi * sum);
}

}  // namespace line_contact
