// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/conventions.hpp"

#include <algorithm>
#include <cmath>

namespace paper {

int decimals_of(const std::vector<double>& points) {
  constexpr int most = 9;
  for (int decimals = 0; decimals < most; ++decimals) {
    const double shift = std::pow(10.0, decimals);
    const auto is_printed = [shift](double x) {
      return std::abs(x * shift - std::round(x * shift)) <= 1e-9 * std::abs(x * shift);
    };
    if (std::all_of(points.begin(), points.end(), is_printed)) return decimals;
  }
  return most;
}

}  // namespace paper
