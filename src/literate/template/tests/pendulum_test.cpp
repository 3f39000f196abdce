#include "pendulum.hpp"

#include <cmath>
#include <cstdio>
#include <numbers>

namespace {

int n_failed = 0;

void claim(const char* text, bool holds) {
  if (holds) return;
  ++n_failed;
  std::printf("not so: %s\n", text);
}

}  // namespace

int main() {
  constexpr double right_angle = std::numbers::pi / 2;
  // K(sin 45°)·2/π, with K = 1.854074677301372 (Abramowitz & Stegun, table 17.1)
  const double tabulated = 1.854074677301372 * 2 / std::numbers::pi;
  const numerics::Estimate period = relative_period(right_angle);
  claim("the period at a right angle is the tabulated one",
        std::abs(period.value - tabulated) < 4e-16 + period.abs_error);
  claim("its error is no more than rounding", period.abs_error < 1e-14);
  claim("small swings take the period of small swings", relative_period(1e-9).value == 1);
  claim("the series is right to the fourth power of the angle",
        std::abs(relative_period(0.1).value - short_series(0.1)) < 0.1 * 0.1 * 0.1 * 0.1 * 11 / 3072 * 1.01);
  return n_failed;
}
