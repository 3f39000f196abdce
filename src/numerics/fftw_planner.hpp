// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fftw3.h>

#include <cstddef>
#include <memory>
#include <mutex>

namespace numerics {

/// FFTW's planner, which makes and frees plans, is one for all threads: hold this meanwhile.
std::mutex& fftw_planner();

struct FreeFftwPlan {
  void operator()(fftw_plan_s* plan) const;
};
using FftwPlan = std::unique_ptr<fftw_plan_s, FreeFftwPlan>;

struct FreeFftwMemory {
  void operator()(void* memory) const { fftw_free(memory); }
};

/// The least size ≥ min_size that is 2^k m, k ≥ 2, with a small odd m that FFTW has code for.
std::size_t convenient_fourier_size(std::size_t min_size);

}  // namespace numerics
