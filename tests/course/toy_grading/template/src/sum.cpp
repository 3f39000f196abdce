// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>

#include "toy.hpp"

double sum(const std::vector<double>& numbers) {
  // BEGIN SOLUTION
  // STUB: static_cast<void>(numbers);
  // STUB: return std::numeric_limits<double>::quiet_NaN();
  double total = 0;
  for (const double number : numbers) total += number;
  return total;
  // END SOLUTION
}
