// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "system/files.hpp"

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

/// Writes the filter of system calls under which a submission runs, in the form that bubblewrap
/// reads. Calls fail with EPERM if no numerical program needs them and if they reach what the
/// limits do not count: memory of System V and of key rings, new namespaces, other processes.
/// Throws sys::ToolError if the filter cannot be made.
void write_syscall_filter(const std::filesystem::path& file);

/// A fence of Landlock (Linux 5.13): within it a process can write, make, rename and remove nothing
/// but these files and what is below these folders, which must exist. Any user can have one. There
/// is no fence, but a descriptor of −1, where the kernel has no Landlock. Throws sys::ToolError if
/// a path cannot be opened.
sys::Descriptor write_fence(const std::vector<std::filesystem::path>& writable);

/// Encloses this process and all that it starts, which also gains no rights by running programs any
/// more. Returns whether the kernel has done so. Allocates nothing.
bool enclose(const sys::Descriptor& fence);

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

/// Does work of this program's own on a text that somebody else wrote in a child process, which is
/// ended if it takes longer than `cpu_seconds` of processor time or `memory_mb` of address space
/// beyond what this process has when it begins, so that no text can hold this process up or crash
/// it. Returns what the work returns; nothing if it was ended, crashed or threw. Not for a process
/// with several threads. Throws sys::ToolError if there can be no child.
std::optional<std::string> apart(const std::function<std::string()>& work, unsigned cpu_seconds,
                                 unsigned memory_mb);

}  // namespace course
