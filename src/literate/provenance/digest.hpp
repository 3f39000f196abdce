// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace literate {

/// The SHA-256 of all files below a folder, lines «hash  file» as sha256sum writes them, sorted.
std::string digest_of(const std::filesystem::path& folder);

/// Checks that a folder holds what the program made. Throws sys::OutputError naming the first file
/// that is not among `made`, or else the first whose SHA-256 differs from the one in `digest_file`,
/// which has the form of digest_of, or the first of `made` that it does not name.
void require_as_made(const std::filesystem::path& folder, const std::filesystem::path& digest_file,
                     const std::vector<std::string>& made);

}  // namespace literate
