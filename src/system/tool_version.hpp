// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace sys {

/// The first line that `program --version` prints; throws ToolError if it is not installed.
std::string tool_version(const std::string& program);

}  // namespace sys
