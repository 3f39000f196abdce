// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace sys {

/// Returns the first line that `program --version` prints; throws ToolError if the program is not
/// installed.
std::string tool_version(const std::string& program);

}  // namespace sys
