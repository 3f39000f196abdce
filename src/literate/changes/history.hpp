// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace literate {

/// What git says, run in a folder, whoever owns the checkout; none if it fails. Throws
/// sys::ToolError where there is no git.
std::optional<std::string> git(const std::filesystem::path& folder,
                               std::vector<std::string> arguments);

}  // namespace literate
