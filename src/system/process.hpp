// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sys {

/// How long a program may take before it is ended.
struct TimeLimit {
  std::string what = {};  ///< begins the message: «figure 'x'», «LaTeX on report.tex»
  int seconds = 0;        ///< 0 for no limit
};

/// The seconds that the variable LITERATE_TIMEOUT gives to every tool; 0 for any time, none where
/// it is not set. Throws InputError if it is anything else.
std::optional<int> given_limit();

/// A program to run as a child, without a shell and with an empty standard input.
struct Command {
  std::string program;
  std::vector<std::string> arguments = {};
  std::filesystem::path working_directory = ".";
  /// Variables that are added to this program's own or replace them.
  std::map<std::string, std::string> environment = {};
  TimeLimit limit = {};
  /// Whether an interrupt ends the child by ending its caller: it does not see the signal, and is
  /// killed as soon as the calling thread is gone.
  bool ends_with_caller = false;
};

struct ProcessResult {
  int exit_status = 0;  ///< as shell_status gives it
  std::string output;   ///< standard output and standard error, interleaved
};

/// How a child ended, for messages: «status 3», «signal 9 (Killed)».
std::string end_of(const ProcessResult& result);

/// Finds a program in the folders of PATH; throws ToolError that names it if it is in none of them.
/// The variable LITERATE_SETUP is the command that installs what is missing, for that message.
std::filesystem::path find_tool(std::string_view program);

/// Runs a child until it ends; several threads may do so at the same time. Throws ToolError if it
/// cannot start, or has not ended within its limit; then it is ended, with all that it started. The
/// variable LITERATE_TIMEOUT, a number of seconds, takes the place of every limit, and lifts it if
/// it is empty or 0; anything else is an InputError. The caller has to look at the exit status.
ProcessResult run(const Command& command);

/// Returns the first line that `program --version` prints; throws ToolError if the program is not
/// installed.
std::string tool_version(const std::string& program);

/// Returns the text of a file of /proc, or as much of it as could be read. A process may end while
/// its files are read; that is no error, so the text is then empty or ends early.
std::string read_proc_file(const std::filesystem::path& file);

/// The numbers of processes or threads among the names in a folder of /proc.
std::vector<pid_t> processes_in(const std::filesystem::path& folder);

/// All processes below a process, whichever of its threads started them, without the process
/// itself. A process that starts or ends meanwhile may be among them or not.
std::vector<pid_t> descendants(pid_t process);

}  // namespace sys
