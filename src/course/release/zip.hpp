// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace course {

/// Unpacks a zip of the project's own making into an existing folder. Throws sys::ToolError if
/// bsdtar is missing or cannot read it.
void unpack_zip(const std::filesystem::path& zip, const std::filesystem::path& folder);

/// A line for each file that is in a zip and not in a folder, or the other way round, or differs.
/// The zip may hold the folder's files as they are, or in one folder. Throws as unpack_zip does.
std::vector<std::string> differences_of_zip(const std::filesystem::path& zip,
                                            const std::filesystem::path& folder);

}  // namespace course
