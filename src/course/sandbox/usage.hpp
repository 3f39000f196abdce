// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <vector>

namespace course {

/// What some processes use together.
struct Usage {
  std::size_t bytes = 0;   ///< of memory; a page that two processes share counts twice
  double cpu_seconds = 0;  ///< including that of their children that have ended
  std::size_t tasks = 0;   ///< processes and threads
  bool is_waiting = true;  ///< whether none of them wants a processor
};

Usage usage_of(const std::vector<pid_t>& processes);

/// The number of processes and threads of this process's user.
std::size_t own_tasks();

}  // namespace course
