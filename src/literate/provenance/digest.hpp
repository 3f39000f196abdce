// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace literate {

/// Throws sys::OutputError naming the first file of a folder that is not as it was made: one whose
/// SHA-256 is not the one that `digest_file` lists (lines «hash  file», as sha256sum writes them),
/// or one that is there and not among `made`.
void require_as_made(const std::filesystem::path& folder, const std::filesystem::path& digest_file,
                     const std::vector<std::string>& made);

}  // namespace literate
