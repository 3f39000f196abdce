// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace literate {

/// All files below a folder of a paper's sources, sorted, as generic paths relative to it; without
/// those of folders below that are a paper of their own (whose CMakeLists.txt calls
/// literate_add_paper). Throws sys::OutputError.
std::vector<std::string> paper_sources(const std::filesystem::path& folder);

}  // namespace literate
