// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/tool_version.hpp"

#include "system/process.hpp"

namespace sys {

std::string tool_version(const std::string& program) {
  const ProcessResult result = run({.program = program, .arguments = {"--version"}});
  return result.output.substr(0, result.output.find('\n'));
}

}  // namespace sys
