#include "pendulum.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace {

// The integrand is periodic and smooth, so the trapezoidal rule converges faster than any power of
// its step.
double trapezoidal(double k, int n_intervals) {
  const double step = std::numbers::pi / 2 / n_intervals;
  double sum = 0.5 * (1 + 1 / std::sqrt(1 - k * k));
  for (int i = 1; i < n_intervals; ++i) {
    const double s = k * std::sin(i * step);
    sum += 1 / std::sqrt(1 - s * s);
  }
  return sum / n_intervals;
}

}  // namespace

numerics::Estimate relative_period(double angle) {
  const double k = std::sin(angle / 2);
  const int n = 64;
  const double coarse = trapezoidal(k, n / 2);
  const double fine = trapezoidal(k, n);
  // Each of the n terms is accurate to a few ε, and so is their mean.
  const double rounding = 8 * std::numeric_limits<double>::epsilon() * fine;
  return {fine, std::abs(fine - coarse) + rounding};
}

double short_series(double angle) {
  return 1 + angle * angle / 16;
}
