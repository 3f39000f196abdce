// SPDX-License-Identifier: GPL-3.0-or-later
// Skips a suite of tests whose tool is not installed; CTest counts it as skipped.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <string>

#include "system/error.hpp"
#include "system/files.hpp"

/// Ends the program as skipped, with one line that names the untested feature and the reason.
[[noreturn]] inline void skip_tests(const std::string& untested, const std::string& why) {
  constexpr int skipped = 77;
  std::printf("skipped: %s: %s\n", untested.c_str(), why.c_str());
  std::fflush(stdout);
  std::_Exit(skipped);
}

/// Skips the tests if the tool is not installed.
inline void need_tool(const std::string& tool, const std::string& untested) {
  try {
    sys::find_tool(tool);
  } catch (const sys::ToolError&) {
    skip_tests(untested, tool + " is not installed");
  }
}
