// SPDX-License-Identifier: GPL-3.0-or-later
#include "elasticity/piecewise_linear_load.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "system/require.hpp"

namespace elasticity {
namespace {

// ∫₋₁¹ {1, τ, 1−τ²} ln|z+τ| dτ.
struct Moments {
  double constant;
  double linear;
  double parabola;
};

double times_log(double t) {
  return t == 0 ? 0 : t * std::log(std::abs(t));
}

// In closed form, p = z + 1 and m = z − 1 given apart since one may be tiny.
Moments near_moments(double p, double m) {
  const double z = (p + m) / 2;
  const double p_log = times_log(p);  // p ln|p|
  const double m_log = times_log(m);  // m ln|m|
  return {p_log - m_log - 2, z - (m * p_log - p * m_log) / 2,
          (p * (2 - z) * p_log + m * (2 + z) * m_log) / 3 + 2 * z * z / 3 - 16.0 / 9};
}

// Without the constant's 2 ln|z| and the parabola's 4/3 ln|z|, as series in η² = 1/z² ≤ 1/4:
//   −Σ η²ᵏ/(k(2k+1)),  2 Σ η²ᵏ⁻¹/((2k−1)(2k+1)),  −2 Σ η²ᵏ/(k(2k+1)(2k+3)),  k = 1, 2, …
Moments far_moments(double eta) {
  constexpr double negligible = 1e-17;
  Moments sum{0, 0, 0};
  double power = 1;
  for (double two_k = 2; power > negligible; two_k += 2) {
    sum.linear += 2 * power * eta / ((two_k - 1) * (two_k + 1));
    power *= eta * eta;
    sum.constant -= 2 * power / (two_k * (two_k + 1));
    sum.parabola -= 4 * power / (two_k * (two_k + 1) * (two_k + 3));
  }
  return sum;
}

// p on the element from begin to end at s; exact at both.
double interpolated(double begin, double end, double at_begin, double at_end, double s) {
  const double share = (s - begin) / (end - begin);
  return share < 0.5 ? at_begin + share * (at_end - at_begin)
                     : at_end - (end - s) / (end - begin) * (at_end - at_begin);
}

// ∫ p ds/(x − s) over an element that lies farther from x than two of its half-lengths, where the
// logarithm of the closed form cancels: with η = 1/z,
//   −[m L₀ + q L₁],  L₀ = 2 artanh η,  L₁ = 2 − z L₀ = −2 Σ η²ᵏ/(2k+1).
double far_part(double z, double mean, double rise) {
  constexpr double negligible = 1e-17;
  const double eta = 1 / z;
  double sum = 0;
  double power = eta * eta;
  for (double odd = 3; power > negligible; odd += 2) {
    sum += power / odd;
    power *= eta * eta;
  }
  return -(2 * mean * std::atanh(eta) - 2 * rise * sum);
}

// Φ(x) = ∫ p(s) ln(|x−s|/width) ds/width.
double potential(const PiecewiseLinearLoad& load, double x) {
  const auto& s = load.positions();
  const auto& p = load.pressures();
  const double width = load.width();
  double sum = 0;
  for (std::size_t i = 0; i + 1 < s.size(); ++i) {
    const ElementPotential part =
        element_potential((s[i] - x) / width, (s[i + 1] - x) / width, (s[i + 1] - s[i]) / width);
    sum += p[i] * part.begin + p[i + 1] * part.end;
  }
  return sum;
}

}  // namespace

ElementPotential element_potential(double begin, double end) {
  return element_potential(begin, end, end - begin);
}

ElementPotential element_potential(double begin, double end, double length) {
  const double l = length / 2;
  const double centre = (begin + end) / 2;
  const bool is_far = std::abs(centre) > 2 * l;
  const Moments m = is_far ? far_moments(l / centre) : near_moments(end / l, begin / l);
  const double log = std::log(is_far ? std::abs(centre) : l);
  const double mean = m.constant / 2 + log;  // ½ ∫ ln|u| dτ
  // The hats that are 1 at the begin and at the end, ½(1 ∓ τ), and the parabola 1 − τ²
  return {l * (mean - m.linear / 2), l * (mean + m.linear / 2), l * (m.parabola + 4 * log / 3)};
}

PiecewiseLinearLoad::PiecewiseLinearLoad(std::vector<double> positions,
                                         std::vector<double> pressures)
    : positions_(std::move(positions)), pressures_(std::move(pressures)) {
  if (positions_.size() < 2 || positions_.size() != pressures_.size()) {
    throw sys::InvalidQuantity("number of positions", static_cast<double>(positions_.size()),
                               "2 or more, and as many as there are pressures");
  }
  for (std::size_t i = 0; i < positions_.size(); ++i) {
    sys::require_finite("pressure", pressures_[i]);
    sys::require_finite("position", positions_[i]);
    if (i == 0 || positions_[i] > positions_[i - 1]) continue;
    throw sys::InvalidQuantity("position", positions_[i], "greater than the one before");
  }
}

double PiecewiseLinearLoad::resultant_below(double x) const {
  double sum = 0;
  for (std::size_t i = 0; i + 1 < positions_.size() && positions_[i] < x; ++i) {
    const double end = std::min(x, positions_[i + 1]);
    const double at_end =
        interpolated(positions_[i], positions_[i + 1], pressures_[i], pressures_[i + 1], end);
    sum += (end - positions_[i]) * (pressures_[i] + at_end) / 2;
  }
  return sum;
}

PiecewiseLinearLoad::operator Load() const {
  Load load;
  std::vector<numerics::Piece> pieces;
  for (std::size_t i = 0; i + 1 < positions_.size(); ++i) {
    pieces.push_back({positions_[i], positions_[i + 1],
                      [begin = positions_[i], end = positions_[i + 1], at_begin = pressures_[i],
                       at_end = pressures_[i + 1]](double s) {
                        return interpolated(begin, end, at_begin, at_end, s);
                      }});
  }
  load.normal = numerics::PiecewiseFunction(pieces);
  return load;
}

double normal_gradient(const Material& material, const PiecewiseLinearLoad& load, double x) {
  sys::require_finite("x", x);
  const auto& s = load.positions();
  const auto& p = load.pressures();
  if ((x == s.front() && p.front() != 0) || (x == s.back() && p.back() != 0)) {
    throw sys::InvalidQuantity("x", x, "off the jump of the load, where the gradient is infinite");
  }
  // At a position the logarithms of its two elements cancel.
  const double width = load.width();
  const auto logarithm = [&](double end) {
    return x == end ? 0 : std::log(std::abs(x - end) / width);
  };
  double sum = 0;
  for (std::size_t i = 0; i + 1 < s.size(); ++i) {
    const double half_length = (s[i + 1] - s[i]) / 2;
    const double z = ((s[i] - x) / 2 + (s[i + 1] - x) / 2) / half_length;
    const double mean = (p[i] + p[i + 1]) / 2;
    const double rise = (p[i + 1] - p[i]) / 2;
    constexpr double near = 2;
    sum += std::abs(z) > near
               ? far_part(z, mean, rise)
               : -((mean - rise * z) * (logarithm(s[i + 1]) - logarithm(s[i])) + 2 * rise);
  }
  return -material.integral_compliance() * sum;
}

double normal_displacement(const Material& material, const PiecewiseLinearLoad& load, double x,
                           double datum) {
  const double here = potential(load, sys::require_finite("x", x));
  const double there = potential(load, sys::require_finite("datum", datum));
  return -material.integral_compliance() * load.width() * (here - there);
}

double tangential_displacement(const Material& material, const PiecewiseLinearLoad& load,
                               double x) {
  const double total = load.resultant_below(load.positions().back());
  const double below = load.resultant_below(sys::require_finite("x", x));
  return -material.local_compliance() / 2 * (2 * below - total);
}

}  // namespace elasticity
