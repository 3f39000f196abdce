// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <thread>
#include <vector>

namespace sys {

/// Calls work(0), …, work(n − 1), at most `n_jobs` of them at the same time (0 means the number of
/// cores), and returns when all have ended. Of several exceptions it throws the one with the lowest
/// index, so that every run throws the same.
template <class Work>
void for_each_parallel(std::size_t n, std::size_t n_jobs, const Work& work) {
  std::vector<std::exception_ptr> errors(n);
  std::atomic<std::size_t> next = 0;
  const auto work_on = [&] {
    for (std::size_t i = next++; i < n; i = next++) {
      try {
        work(i);
      } catch (...) {
        errors[i] = std::current_exception();
      }
    }
  };
  {
    const std::size_t n_cores = std::max(1U, std::thread::hardware_concurrency());
    std::vector<std::jthread> threads;
    for (std::size_t i = 0; i < std::min(n, n_jobs == 0 ? n_cores : n_jobs); ++i) {
      threads.emplace_back(work_on);
    }
  }
  for (const auto& error : errors) {
    if (error) std::rethrow_exception(error);
  }
}

}  // namespace sys
