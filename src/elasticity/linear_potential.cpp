// SPDX-License-Identifier: GPL-3.0-or-later
#include "elasticity/linear_potential.hpp"

#include <cmath>

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

}  // namespace elasticity
