// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace sys {

/// Returns the text of a file of /proc, or as much of it as could be read. A process may end while
/// its files are read; that is no error, so the text is then empty or ends early.
std::string read_proc_file(const std::filesystem::path& file);

}  // namespace sys
