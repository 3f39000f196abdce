// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/tool.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <cstdlib>
#include <sstream>

#include "system/error.hpp"

namespace sys {
namespace fs = std::filesystem;

fs::path find_tool(const std::string& program) {
  const char* const path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');) {
    const fs::path file = fs::path(folder) / program;
    std::error_code error;
    if (fs::is_regular_file(file, error) && ::access(file.c_str(), X_OK) == 0) return file;
  }
  throw ToolError(fmt::format("{} is not installed: run `make setup`", program));
}

}  // namespace sys
