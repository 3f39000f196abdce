// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace course {

/// Unpacks a zip that this project made into an existing folder. Throws sys::ToolError if
/// bsdtar is missing or cannot read the zip.
void unpack_zip(const std::filesystem::path& zip, const std::filesystem::path& folder);

/// A line for each file that differs between a zip and a folder or is missing in one of them.
/// The zip may hold the files at its top or in one folder. Throws as unpack_zip does.
std::vector<std::string> differences_of_zip(const std::filesystem::path& zip,
                                            const std::filesystem::path& folder);

}  // namespace course
