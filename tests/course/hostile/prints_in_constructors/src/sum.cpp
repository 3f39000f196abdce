// SPDX-License-Identifier: GPL-3.0-or-later
#include "toy.hpp"

double sum(const std::vector<double>& numbers) {
  double total = 0;
  for (const double number : numbers) total += number;
  return total;
}
