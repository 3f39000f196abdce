// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace course {

/// Whether a job is kept apart from everything else, or only within its limits.
enum class Isolation { sandbox, none };

/// A file or folder that a job may read, and where it finds it.
struct Readable {
  std::filesystem::path path;
  std::string place;  ///< in the sandbox, such as "/toolkit"
};

/// A program to run apart from everything else, its streams being files.
struct Job {
  std::vector<std::string> command;  ///< whole paths, as Sandbox::place tells them
  std::vector<Readable> readable;
  std::string folder;  ///< it starts in, as the job sees it; empty: scratch()
  std::filesystem::path input = "/dev/null";
  std::filesystem::path output;
  std::filesystem::path errors;
  int seconds = 5;       ///< of the processor, all together; the job has twice as long by the clock
  int memory_mb = 1024;  ///< of address space, each process, and of memory, all together
  int processes = 32;    ///< and threads
  int file_kb = 256;     ///< of each file and stream it writes
  int scratch_mb = 0;    ///< of scratch(); 0: it can write nothing but its streams
};

enum class Ending { normal, too_slow, too_large, too_many_processes, too_much_output, crash };

struct JobEnd {
  Ending ending = Ending::normal;
  int status = 0;  ///< of a normal end: exit status; of a crash: number of the signal
};

/// Runs jobs so that they reach no file, process or network but their own, within limits.
///
/// bubblewrap keeps them apart. For root they run as a user of this process's own, so that the
/// limit of processes counts each grading alone. With Isolation::none the limits hold, nothing is
/// left behind, and root's jobs cannot reach each other's folders; nothing else is kept apart.
class Sandbox {
 public:
  /// `work` is an existing folder for its own files. Tries bubblewrap; throws ToolError where it
  /// does not work.
  Sandbox(Isolation isolation, const std::filesystem::path& work);

  /// Runs a job to its end. Throws ToolError if it cannot start.
  JobEnd run(const Job& job) const;

  /// Where a job finds what it may read.
  std::string place(const Readable& readable) const;

  /// The only folder that a job may write to; it is empty at first and goes after the job.
  std::string scratch() const;

 private:
  void probe() const;
  std::vector<std::string> command(const Job& job) const;
  std::vector<std::string> walls(const Job& job) const;
  void prepare_scratch() const;
  void make_reachable() const;

  Isolation isolation_;
  std::filesystem::path work_;
  bool is_root_;
  unsigned user_;  ///< of the jobs, where is_root_
};

/// Makes a file or folder and all below readable to all users, as jobs are others than this one.
void make_readable(const std::filesystem::path& path);

}  // namespace course
