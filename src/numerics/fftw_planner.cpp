// SPDX-License-Identifier: GPL-3.0-or-later
#include "numerics/fourier.hpp"

#include <algorithm>
#include <bit>

namespace numerics {

std::mutex& fftw_planner() {
  static std::mutex planner;
  return planner;
}

void FreeFftwPlan::operator()(fftw_plan_s* plan) const {
  const std::scoped_lock lock(fftw_planner());
  fftw_destroy_plan(plan);
}

std::size_t convenient_fourier_size(std::size_t min_size) {
  std::size_t best = std::bit_ceil(std::max<std::size_t>(min_size, 4));
  for (const std::size_t odd : {3U, 5U, 7U, 9U, 15U}) {
    std::size_t size = 4 * odd;
    while (size < min_size) size *= 2;
    best = std::min(best, size);
  }
  return best;
}

}  // namespace numerics
