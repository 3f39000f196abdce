// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <vector>

namespace course {

/// All processes below one, whichever thread started them, itself left out. One that starts or ends
/// meanwhile may be in it or not.
std::vector<pid_t> descendants(pid_t process);

/// What processes use together.
struct Usage {
  std::size_t bytes = 0;   ///< in memory; a page that two of them share counts twice
  double cpu_seconds = 0;  ///< with that of their children that have ended
  std::size_t tasks = 0;   ///< processes and threads
};

Usage usage_of(const std::vector<pid_t>& processes);

/// Processes and threads of this process's user.
std::size_t own_tasks();

}  // namespace course
