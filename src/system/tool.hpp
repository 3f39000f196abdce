// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace sys {

/// Finds a program in the folders of PATH. Throws ToolError with its name if it is not there.
std::filesystem::path find_tool(const std::string& program);

}  // namespace sys
