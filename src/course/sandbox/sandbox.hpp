// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace course {

/// Whether a job is kept apart from everything else, or only within its limits.
enum class Isolation { sandbox, none };

/// A file or folder that a job may read, and the path by which the job finds it.
struct Readable {
  std::filesystem::path path;
  std::string place;  ///< in the sandbox, such as "/toolkit"
};

/// A program to run apart from everything else. Its streams are files.
struct Job {
  std::vector<std::string> command;  ///< with absolute paths, as Sandbox::place gives them
  std::vector<Readable> readable;
  std::string folder;  ///< where it starts, as the job sees it; empty: scratch()
  std::filesystem::path input = "/dev/null";
  std::filesystem::path output;
  std::filesystem::path errors;
  /// Of processor time, for all processes together, and twice that by the clock in which none of
  /// them wants a processor.
  int seconds = 5;
  double waiting_seconds = 0;  ///< instead of that twice as much; 0: twice as much
  /// Of memory for all together, and, with a stack for each of `processes`, of address space for
  /// each.
  int memory_mb = 1024;
  int processes = 32;  ///< and threads
  int file_kb = 256;   ///< of each file and stream it writes
  int scratch_mb = 0;  ///< size of scratch(); 0: the job can write nothing but its streams
};

enum class Ending { normal, too_slow, too_large, too_many_processes, too_much_output, crash };

struct JobEnd {
  Ending ending = Ending::normal;
  int status = 0;      ///< the exit status after a normal end, the signal's number after a crash
  double seconds = 0;  ///< of processor time, and in which nothing wanted a processor
};

/// The user as whom root's jobs run. No other process uses it as long as this one lives. Throws
/// sys::ToolError if no user is left or no lock can be made.
unsigned job_user();

/// Runs jobs within limits and so that they reach no file, process or network but their own.
///
/// bubblewrap keeps them apart. If root starts them, they run as a user that only this process
/// uses, so that the limit on processes counts each grading alone. With Isolation::none the limits
/// hold, system calls are refused as within walls (network and shared memory among them), no
/// process is left behind, and root's jobs cannot reach each other's folders. Where the kernel has
/// Landlock (5.13), jobs of any user write to nothing but scratch(); elsewhere what root's jobs
/// leave is removed. Nothing else is kept apart.
class Sandbox {
 public:
  /// `work` is an existing folder for the sandbox's own files. Tries bubblewrap, and throws
  /// ToolError if it does not work.
  Sandbox(Isolation isolation, const std::filesystem::path& work);

  /// Runs a job to its end. Its output and errors are new files, whatever stood there. Throws
  /// ToolError if it cannot start.
  JobEnd run(const Job& job) const;

  /// The path by which a job finds what it may read.
  std::string place(const Readable& readable) const;

  /// The only folder that a job may write to. It is empty at first and is removed after the job.
  std::string scratch() const;

 private:
  void probe() const;
  std::vector<std::string> command(const Job& job) const;
  std::vector<std::string> walls(const Job& job) const;
  std::vector<std::string> environment() const;
  void prepare_scratch() const;
  void make_reachable() const;

  Isolation isolation_;
  std::filesystem::path work_;
  bool is_root_;
  unsigned user_;  ///< as whom jobs run if is_root_
};

/// Makes a file or folder and everything below it readable to all users, because jobs run as other
/// users.
void make_readable(const std::filesystem::path& path);

}  // namespace course
