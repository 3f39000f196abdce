// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace sys {

/// A program to run as a child, without a shell and with an empty standard input.
struct Command {
  std::string program;
  std::vector<std::string> arguments = {};
  std::filesystem::path working_directory = ".";
  /// Variables that are added to this program's own or replace them.
  std::map<std::string, std::string> environment = {};
};

struct ProcessResult {
  int exit_status = 0;  ///< as shell_status gives it
  std::string output;   ///< standard output and standard error, interleaved
};

/// Finds a program in the folders of PATH; throws ToolError that names it and `make setup` if it is
/// in none of them.
std::filesystem::path find_tool(std::string_view program);

/// Runs a child until it ends; several threads may do so at the same time. Throws ToolError if it
/// cannot start. The caller has to look at its exit status.
ProcessResult run(const Command& command);

}  // namespace sys
