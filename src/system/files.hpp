// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace sys {

/// Reads a whole file. Throws OutputError with its name if that fails.
std::string read_file(const std::filesystem::path& file);

/// Writes a new file and renames it to this one, so that readers see either the old or the new
/// text. Creates the folder if it is missing. Throws OutputError with the name of the file.
void write_file_atomically(const std::filesystem::path& file, std::string_view text);

/// Calls write_file_atomically unless the file already contains this text, so that an unchanged
/// file keeps its time stamp. Returns whether the file was written.
bool write_if_changed(const std::filesystem::path& file, std::string_view text);

/// Removes a file if it exists. Throws OutputError with its name if that fails.
void remove_file(const std::filesystem::path& file);

/// Finds a program in the folders of PATH. Throws ToolError with its name if it is not there.
std::filesystem::path find_tool(const std::string& program);

}  // namespace sys
