// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <spawn.h>

#include <filesystem>
#include <string>
#include <vector>

#include "system/error.hpp"
#include "system/files.hpp"

namespace sys {

/// What a child does to its folder and descriptors between fork and exec, in the order of the calls
/// here. Each throws std::system_error if memory runs out.
class FileActions {
 public:
  FileActions();
  FileActions(const FileActions&) = delete;
  FileActions& operator=(const FileActions&) = delete;
  ~FileActions();

  void open(int descriptor, const std::filesystem::path& file, int flags, mode_t mode = 0);
  /// Makes `descriptor` a copy of `source`.
  void duplicate(int source, int descriptor);
  void change_folder(const std::filesystem::path& folder);

  /// Closes all descriptors from this number on.
  void close_from(int descriptor);

  const posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_{};
};

/// The null-terminated array that exec takes; it points into `texts`.
std::vector<char*> exec_pointers(std::vector<std::string>& texts);

struct Pipe {
  Descriptor reading;
  Descriptor writing;
};

/// Opens a pipe that no child inherits, with further flags of pipe2; throws ToolError on failure.
Pipe open_pipe(int flags = 0);

/// Turns a child's wait status into the status that a shell reports: its exit status, or 128 + the
/// number of the signal that ended it.
int shell_status(int wait_status);

/// The error for a program that could not be started, with the system's reason for this `errno`.
ToolError cannot_start(const std::string& program, int error);

}  // namespace sys
