// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace course {

/// Reads a regular file below a folder that somebody else wrote. It follows no symbolic link
/// and reads nothing but a regular file. Throws std::invalid_argument whose message completes «file
/// …»: "is missing", "is a symbolic link", "is larger than 256 kB".
std::string read_beneath(const std::filesystem::path& folder, const std::string& file,
                         std::size_t max_bytes);

}  // namespace course
