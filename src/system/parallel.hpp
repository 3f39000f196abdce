// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>

namespace sys {

/// Calls work(0), …, work(n − 1), at most `n_jobs` of them at the same time (0 stands for the
/// number of cores), and returns when all are done. If some throw, throws the exception of the
/// lowest index, so that it is the same in every run.
void for_each_parallel(std::size_t n, std::size_t n_jobs,
                       const std::function<void(std::size_t)>& work);

}  // namespace sys
