// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace sys {

/// A program to run as a child, without a shell and with nothing on its standard input.
struct Command {
  std::string program;
  std::vector<std::string> arguments = {};
  std::filesystem::path working_directory = ".";
  std::map<std::string, std::string> environment =
      {};  ///< added to this program's own, or replacing
};

struct ProcessResult {
  int exit_status = 0;  ///< 128 + signal number for a child that a signal ended
  std::string output;   ///< standard output and standard error as they came
};

/// Finds a program on the PATH; throws ToolError naming it and `make setup` if it is not there.
std::filesystem::path find_tool(std::string_view program);

/// Runs a child to its end; threads may do so at the same time. Throws ToolError if it cannot
/// start; an exit status other than 0 is the caller's to judge.
ProcessResult run(const Command& command);

}  // namespace sys
