// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/elements/multipole.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace point_contact {
namespace {

using Complex = std::complex<double>;

// A homogeneous polynomial of degree 2k in Z and Z̄: the coefficients of Z^q Z̄^{2k−q}, q = 0 … 2k.
using Homogeneous = std::vector<Complex>;
using Series = std::vector<Homogeneous>;  // by k

std::size_t index(int i) {
  return static_cast<std::size_t>(i);
}

double factorial(int n) {
  return std::tgamma(n + 1.0);
}

// sinh(t/2)/(t/2) = Σ t^{2k}/(4^k (2k+1)!) with t = e·∇ = (ēZ + eZ̄)/2.
Series smearing(const Vector2& direction, int max_order) {
  const Complex e(direction.x(), direction.y());
  Series series;
  for (int k = 0; k <= max_order; ++k) {
    Homogeneous polynomial(index(2 * k + 1));
    const double scale = std::pow(16.0, -k) / factorial(2 * k + 1);
    for (int q = 0; q <= 2 * k; ++q) {
      const double binomial = factorial(2 * k) / (factorial(q) * factorial(2 * k - q));
      polynomial[index(q)] = scale * binomial * std::pow(std::conj(e), q) * std::pow(e, 2 * k - q);
    }
    series.push_back(std::move(polynomial));
  }
  return series;
}

Series product(const Series& a, const Series& b) {
  Series result;
  for (std::size_t k = 0; k < a.size(); ++k) {
    Homogeneous sum(2 * k + 1);
    for (std::size_t l = 0; l <= k; ++l) {
      for (std::size_t p = 0; p < a[l].size(); ++p) {
        for (std::size_t q = 0; q < b[k - l].size(); ++q) sum[p + q] += a[l][p] * b[k - l][q];
      }
    }
    result.push_back(std::move(sum));
  }
  return result;
}

double double_factorial(int n) {
  double result = 1;
  for (; n > 1; n -= 2) result *= n;
  return result;
}

}  // namespace

Multipole::Multipole(std::span<const Vector2> directions) {
  Series series(max_order + 1);
  for (int k = 0; k <= max_order; ++k) series[index(k)].resize(index(2 * k + 1));
  series[0][0] = 1;
  for (const Vector2& direction : directions)
    series = product(series, smearing(direction, max_order));

  // The support is a sum of segments, whose farthest corner is the sum of their halves.
  for (std::size_t signs = 0; signs < (std::size_t{1} << directions.size()); ++signs) {
    Vector2 corner = Vector2::Zero();
    for (std::size_t i = 0; i < directions.size(); ++i) {
      corner += ((signs >> i) & 1U ? 0.5 : -0.5) * directions[i];
    }
    reach_ = std::max(reach_, corner.norm());
  }

  // Z^q Z̄^{2k−q} with m = 2q − 2k; that of −m is the complex conjugate.
  for (int k = 0; k <= max_order; ++k) {
    std::vector<Term> terms;
    const double negligible = 1e-18 * std::pow(reach_, 2 * k);
    for (int half_m = 0; half_m <= k; ++half_m) {
      const int m = 2 * half_m;
      const double factor = double_factorial(2 * k - m - 1) * double_factorial(2 * k + m - 1);
      const Complex coefficient =
          (m == 0 ? 1.0 : 2.0) * factor * series[index(k)][index(k + half_m)];
      if (std::abs(coefficient) > negligible) terms.push_back({half_m, coefficient});
    }
    orders_.push_back(std::move(terms));
  }
}

double Multipole::potential(const Vector2& d) const {
  const double r2 = d.squaredNorm();
  const double shrinkage = reach_ * reach_ / r2;
  // e^{imθ}, m = 0, 2, …
  const Complex turn = Complex(d.x() * d.x() - d.y() * d.y(), 2 * d.x() * d.y()) / r2;
  std::array<Complex, max_order + 1> turns;
  turns[0] = 1;
  double sum = 0;
  double power = 1;  // r^{−2k}
  double bound = 1;  // (reach/r)^{2k}
  for (std::size_t k = 0; k < orders_.size() && bound > std::numeric_limits<double>::epsilon() / 8;
       ++k) {
    if (k > 0) {
      const Complex& last = turns[k - 1];
      turns[k] = {last.real() * turn.real() - last.imag() * turn.imag(),
                  last.real() * turn.imag() + last.imag() * turn.real()};
    }
    double order = 0;
    for (const Term& term : orders_[k]) {
      const Complex& e = turns[index(term.half_m)];
      order += term.coefficient.real() * e.real() - term.coefficient.imag() * e.imag();
    }
    sum += order * power;
    power /= r2;
    bound *= shrinkage;
  }
  return sum / std::sqrt(r2);
}

}  // namespace point_contact
