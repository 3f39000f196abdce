// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace sys {

/// Returns the text of a file of /proc, or as much of it as could be read. A process may end while
/// its files are read; that is no error, so the text is then empty or ends early.
std::string read_proc_file(const std::filesystem::path& file);

/// The numbers of processes or threads among the names in a folder of /proc.
std::vector<pid_t> processes_in(const std::filesystem::path& folder);

/// All processes below a process, whichever of its threads started them, without the process
/// itself. A process that starts or ends meanwhile may be among them or not.
std::vector<pid_t> descendants(pid_t process);

}  // namespace sys
