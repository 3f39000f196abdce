// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace sys {

/// Reads a whole file; throws OutputError naming it if it cannot be read.
std::string read_file(const std::filesystem::path& file);

/// Writes beside the file and renames, making its folder if need be: readers see the old or the
/// new text, never a part. Throws OutputError naming the file.
void write_file_atomically(const std::filesystem::path& file, std::string_view text);

/// As write_file_atomically, but leaves a file that holds this text already, with its time stamp.
/// Returns whether it wrote.
bool write_if_changed(const std::filesystem::path& file, std::string_view text);

/// The SHA-256 of a text in lower-case hexadecimal.
std::string sha256_of_text(std::string_view text);

/// The same of a file's bytes; throws OutputError naming a file that cannot be read.
std::string sha256_of_file(const std::filesystem::path& file);

/// All regular files below a folder, sorted, as generic paths relative to it; throws OutputError.
std::vector<std::string> files_below(const std::filesystem::path& folder);

}  // namespace sys
