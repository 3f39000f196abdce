// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace course {

/// Runs g++ for a product of the toolkit. Throws sys::ToolError with what it says if it fails.
void run_compiler(std::vector<std::string> arguments, const std::filesystem::path& product);

}  // namespace course
