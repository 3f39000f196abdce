// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/changes/history.hpp"

#include "system/process.hpp"

namespace literate {

std::optional<std::string> git(const std::filesystem::path& folder,
                               std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), {"-c", "safe.directory=*"});
  const sys::ProcessResult result =
      sys::run({.program = "git", .arguments = arguments, .working_directory = folder});
  if (result.exit_status != 0) return std::nullopt;
  return result.output;
}

}  // namespace literate
