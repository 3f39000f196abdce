// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace course {

/// Unpacks a zip of the project's own making into an existing folder. Throws literate::ToolError if
/// bsdtar is missing or cannot read it.
void unpack_zip(const std::filesystem::path& zip, const std::filesystem::path& folder);

}  // namespace course
