// SPDX-License-Identifier: GPL-3.0-or-later
#include "decay.hpp"

#include <cmath>

namespace {

// begin excerpt: share-left
// A half-life is the time in which one half of the sample decays:
// n = n₀ · 2^(−t/T), and so λ = ln 2 / T ≥ 0.
double share(double time, double half_life) {
  return std::exp2(
      -time /
      half_life);  // a comment that is long enough to be broken in a narrow column of a journal
}
// end excerpt: share-left

double trapezoidal(int n_intervals) {
  const double end = 60;
  const double step = end / n_intervals;
  double sum = 0.5 * (share(0, 1) + share(end, 1));
  for (int i = 1; i < n_intervals; ++i) sum += share(i * step, 1);
  return sum * step;
}

}  // namespace

numerics::Estimate share_left(double time, double half_life) {
  const double left = share(time, half_life);
  return {left, 4e-16 * left};
}

numerics::Estimate mean_life(int n_intervals) {
  const double coarse = trapezoidal(n_intervals / 2), fine = trapezoidal(n_intervals);
  return {fine, std::abs(fine - coarse) / 2};
}
