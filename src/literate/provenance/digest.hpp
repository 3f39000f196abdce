// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace literate {

/// Checks that a folder holds what the program made. Throws sys::OutputError naming the first file
/// that is not among `made`, or else the first whose SHA-256 differs from the one in `digest_file`,
/// which has lines «hash  file» as sha256sum writes them.
void require_as_made(const std::filesystem::path& folder, const std::filesystem::path& digest_file,
                     const std::vector<std::string>& made);

}  // namespace literate
