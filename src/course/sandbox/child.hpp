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
  /// A file of write_syscall_filter, which holds for the child and all its descendants; empty:
  /// none.
  std::filesystem::path filter = {};
  /// Unless it is empty, they can write nothing but these files and folders and their streams,
  /// where the kernel has Landlock.
  std::vector<std::filesystem::path> writable = {};
  // What the child and all its descendants may use together; 0 means no limit.
  std::size_t memory_mb = 0;
  double cpu_seconds = 0;
  // By the clock, of which only what this process saw counts: if it was stopped itself or got no
  // processor, so may the child have been.
  double waiting_seconds = 0;  ///< in which none of them wants a processor
  double clock_seconds = 0;    ///< in all
  std::size_t tasks = 0;       ///< processes and threads
};

/// A limit that was exceeded, so that the child was killed.
enum class Excess { none, memory, time, tasks };

struct ChildEnd {
  int status = 0;  ///< exit status, or 128 + the number of the signal that ended it
  Excess excess = Excess::none;
  double cpu_seconds = 0;      ///< of the child and all its descendants
  double waiting_seconds = 0;  ///< in which none of them wanted a processor
};

/// Runs a child to its end and then ends all processes that it leaves behind, daemons included.
/// They also end if this process is killed. Throws sys::ToolError if it cannot start, or if the
/// kernel does not take the filter or the fence around what is writable.
ChildEnd run_child(const Child& child);

}  // namespace course
