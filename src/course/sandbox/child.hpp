// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace course {

/// A child process whose standard streams are files, so that a limit on file sizes holds for
/// what it prints. It inherits no environment and no other descriptors.
struct Child {
  std::vector<std::string> command;      ///< begins with the program's absolute path
  std::vector<std::string> environment;  ///< NAME=value
  std::filesystem::path folder;          ///< where it starts
  std::filesystem::path input, output, errors;
  std::filesystem::path third = "/dev/null";  ///< it can read this as descriptor 3
  // What the child and all its descendants may use together; 0 means no limit.
  std::size_t memory_mb = 0;
  double cpu_seconds = 0;
  double waiting_seconds = 0;  ///< by the clock, in which none of them wants a processor
  std::size_t tasks = 0;       ///< processes and threads
};

/// A limit that was exceeded, so that the child was killed.
enum class Excess { none, memory, time, tasks };

struct ChildEnd {
  int status = 0;  ///< exit status, or 128 + the number of the signal that ended it
  Excess excess = Excess::none;
  double cpu_seconds = 0;  ///< of the child and those of its descendants that have ended
};

/// Runs a child to its end and then ends all processes that it leaves behind, daemons included.
/// Throws sys::ToolError if it cannot start.
ChildEnd run_child(const Child& child);

}  // namespace course
