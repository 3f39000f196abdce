// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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

}  // namespace sys
