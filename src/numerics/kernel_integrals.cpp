// SPDX-License-Identifier: GPL-3.0-or-later
#include "numerics/kernel_integrals.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "system/require.hpp"

namespace numerics {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

// Adds the rounding of one sum of a few dozen terms of the given magnitude.
Estimate with_rounding(Estimate e, double magnitude) {
  constexpr double roundings = 8;
  e.abs_error += roundings * epsilon * magnitude;
  return e;
}

// ∫ ln(t/length) dt from 0 to t.
double logarithm_integral(double t, double length) {
  return t > 0 ? t * (std::log(t / length) - 1) : 0;
}

// Sums the logarithms ln|x − end| of the constants split off. If x is at an end, that logarithm is
// infinite: its factors cancel at a kink, but not at a jump.
class EndLogarithms {
 public:
  EndLogarithms(double x, double length, double scale) : x_(x), length_(length), scale_(scale) {}

  void add(double factor, double end) {
    if (x_ == end) {
      factor_at_x_ += factor;
      return;
    }
    const double term = factor * std::log(std::abs(x_ - end) / length_);
    sum_.value += term;
    magnitude_ += std::abs(term);
  }

  Estimate sum() const {
    constexpr double rounding_of_density = 16 * epsilon;
    if (std::abs(factor_at_x_) > rounding_of_density * scale_) {
      throw sys::InvalidQuantity("x", x_,
                                 "away from the jump of the load, where the gradient is infinite");
    }
    return with_rounding(sum_, magnitude_);
  }

 private:
  double x_;
  double length_;
  double scale_;
  double factor_at_x_ = 0;
  double magnitude_ = 0;
  Estimate sum_;
};

// The position of x in units of the piece: −1 at its begin, +1 at its end. QAWC's moments contain
// the logarithm of the distance from ±1.
double relative_position(const Piece& piece, double x) {
  return ((x - piece.begin) + (x - piece.end)) / (piece.end - piece.begin);
}

}  // namespace

KernelIntegrals::KernelIntegrals(const PiecewiseFunction& density, double rel_tolerance)
    : density_(resolved(density)),
      rel_tolerance_(sys::require_positive("rel_tolerance", rel_tolerance)) {}

Estimate KernelIntegrals::cauchy(double x) const {
  sys::require_finite("x", x);
  Estimate sum;
  if (density_.is_zero()) return sum;
  const double length = density_.pieces().back().end - density_.pieces().front().begin;
  EndLogarithms logarithms(x, length, density_.scale());
  for (const Piece& piece : density_.pieces()) {
    const bool is_far = std::abs(relative_position(piece, x)) > 3;
    const double nearest = is_far ? 0 : piece.value(std::clamp(x, piece.begin, piece.end));

    // PV∫ c/(x − s) ds = c ln|(x − begin)/(x − end)|
    logarithms.add(nearest, piece.begin);
    logarithms.add(-nearest, piece.end);

    // PV∫ [p(s) − c]/(x − s) ds
    const Estimate rest = cauchy_regular_part(piece, nearest, x);
    sum += with_rounding(rest, std::abs(rest.value));
  }
  return sum + logarithms.sum();
}

Estimate KernelIntegrals::cauchy_regular_part(const Piece& piece, double nearest_value,
                                              double x) const {
  const double abs_tolerance = rel_tolerance_ * density_.scale();
  const IntegralName name{"principal value of p(s)/(x - s)", x};
  const double position = std::abs(relative_position(piece, x));

  // Where QAWC cannot distinguish x from an end, the integrand has no pole.
  constexpr double indistinguishable = 64 * epsilon;
  if (std::abs(position - 1) < indistinguishable) {
    double greatest = 0;
    const auto quotient = [&](double s) {
      const double value = (piece.value(s) - nearest_value) / (x - s);
      greatest = std::max(greatest, std::abs(value));
      return value;
    };
    Estimate rest = quadrature_.smooth(quotient, piece.begin, piece.end, abs_tolerance, name);
    // The rounding of s matters where the quotient grows towards the end, such as for a density
    // that ends like a square root.
    rest.abs_error += epsilon * std::max(std::abs(piece.begin), std::abs(piece.end)) * greatest;
    return rest;
  }

  // Within QAWC's own limit for treating x as a pole; ∫ f/(x − s) is −∫ f/(s − x).
  if (position <= 1.1) {
    const auto difference = [&](double s) { return piece.value(s) - nearest_value; };
    return -quadrature_.principal_value(difference, piece.begin, piece.end, x, abs_tolerance, name);
  }

  // Farther away, v = ln(|x − s|/distance) absorbs the kernel: ds/(x − s) = ±dv.
  const bool at_begin = x < piece.begin;
  const double distance = at_begin ? piece.begin - x : x - piece.end;
  const auto substituted = [&](double v) {
    const double t = distance * std::expm1(v);
    return piece.value(at_begin ? piece.begin + t : piece.end - t) - nearest_value;
  };
  const double end = std::log1p((piece.end - piece.begin) / distance);
  const Estimate magnitude =
      quadrature_.adaptive(substituted, 0, end, abs_tolerance, name, GaussKronrod::points_15);
  return at_begin ? -magnitude : magnitude;
}

Estimate KernelIntegrals::logarithmic(double x, double length) const {
  sys::require_finite("x", x);
  sys::require_positive("length", length);
  Estimate sum;
  for (const Piece& piece : density_.pieces()) {
    if (x <= piece.begin) {
      sum += logarithmic_from({piece.value, piece.begin, piece.end, piece.begin - x}, x, length);
    } else if (x >= piece.end) {
      sum += logarithmic_from({piece.value, piece.end, piece.begin, x - piece.end}, x, length);
    } else {
      sum += logarithmic_from({piece.value, x, piece.begin, 0}, x, length);
      sum += logarithmic_from({piece.value, x, piece.end, 0}, x, length);
    }
  }
  return sum;
}

Estimate KernelIntegrals::logarithmic_from(const Panel& panel, double x, double length) const {
  const double width = std::abs(panel.far_end - panel.near_end);
  const double distance = panel.distance;
  const double abs_tolerance = rel_tolerance_ * density_.scale() * width;
  const IntegralName name{"integral of p(s) ln|x - s|", x};
  const auto value_at = [&](double t) {
    return panel.value(panel.near_end + std::copysign(t, panel.far_end - panel.near_end));
  };

  if (distance > 2 * width) {
    const auto product = [&](double t) { return value_at(t) * std::log((distance + t) / length); };
    // Very far away the logarithm is large and nearly constant: its rounding limits the tolerance.
    const double magnitude = std::max(1.0, std::abs(std::log(distance / length)));
    const Estimate whole = quadrature_.smooth(product, 0, width, magnitude * abs_tolerance, name);
    return with_rounding(whole, std::abs(whole.value));
  }

  // ∫ [p − c] ln((distance + t)/length) dt with t = width·y⁴: a 31-point rule integrates the
  // resulting y⁷ ln y in one step. c is p at the end nearest to x.
  const double nearest = value_at(0);
  const auto graded = [&](double y) {
    const double cube = y * y * y;
    const double t = width * cube * y;
    return (value_at(t) - nearest) * std::log((distance + t) / length) * 4 * width * cube;
  };
  const Estimate rest = quadrature_.adaptive(graded, 0, 1, abs_tolerance, name);
  const double far = logarithm_integral(distance + width, length);
  const double near = logarithm_integral(distance, length);
  const double magnitude =
      std::abs(rest.value) + std::abs(nearest) * (std::abs(far) + std::abs(near));
  return with_rounding({rest.value + nearest * (far - near), rest.abs_error}, magnitude);
}

Estimate KernelIntegrals::integral_below(double x) const {
  Estimate sum;
  for (const Piece& piece : density_.pieces()) {
    if (x <= piece.begin) break;
    const double end = std::min(x, piece.end);
    const Estimate part = quadrature_.smooth(
        piece.value, piece.begin, end, rel_tolerance_ * density_.scale() * (end - piece.begin),
        {"integral of p(s)", x});
    sum += with_rounding(part, std::abs(part.value));
  }
  return sum;
}

Estimate KernelIntegrals::total() const {
  return density_.is_zero() ? Estimate{} : integral_below(density_.pieces().back().end);
}

}  // namespace numerics
