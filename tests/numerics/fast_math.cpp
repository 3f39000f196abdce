// SPDX-License-Identifier: GPL-3.0-or-later
// Compiled with -ffast-math, which allows a different order of evaluation: bounds must remain
// bounds.
#include <cmath>
#include <cstdio>

#include "numerics/estimate.hpp"

int main(int argc, char** /*argv*/) {
  const double tenth = argc * 0.1;  // unknown to the compiler
  numerics::Estimate sum;
  for (int i = 0; i < 1000; ++i) sum = sum + numerics::Estimate{tenth, 0};
  numerics::Estimate product{1, 0};
  for (int i = 0; i < 1000; ++i) product = product * (1 + tenth);
  // 1000·0.1 is 100 and 1.1^1000 is exp(1000 log1p(0.1)), to roundings that are less than the
  // bounds
  const double off_sum = std::abs(sum.value - 100);
  const double off_product = std::abs(product.value / std::exp(1000 * std::log1p(0.1)) - 1);
  std::printf("%g of %g, %g of %g\n", off_sum, sum.abs_error, off_product,
              product.abs_error / product.value);
  const bool hold = off_sum <= sum.abs_error && off_product <= product.abs_error / product.value;
  const bool are_tight = sum.abs_error < 1e-10 && product.abs_error < 1e-12 * product.value;
  return hold && are_tight ? 0 : 1;
}
