// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>

namespace sys {

/// Calls work(0), …, work(n − 1), up to `n_jobs` of them at a time (0: as many as there are
/// cores), and returns when all are done. Throws what the lowest of those that failed threw, so
/// that it is the same in every run.
void for_each_parallel(std::size_t n, std::size_t n_jobs,
                       const std::function<void(std::size_t)>& work);

}  // namespace sys
