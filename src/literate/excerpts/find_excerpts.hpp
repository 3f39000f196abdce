// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "literate/excerpts/excerpt.hpp"

namespace literate {

/// Finds the excerpts of one file's text, in the order of the file. Throws sys::SourceError
/// «file:line: message» for a marker that is malformed, unclosed, unmatched, nested or doubled,
/// for an excerpt without text, and for a character that latex_of has no mapping for.
std::vector<Excerpt> excerpts_of(std::string_view text, const std::string& file);

/// Finds the excerpts of all text files below the given folders of `source_root`, which may be files
/// themselves, sorted by name. Throws sys::SourceError as excerpts_of does, and for a name that is marked in two files
/// or a folder that does not exist.
std::vector<Excerpt> find_excerpts(const std::filesystem::path& source_root,
                                   const std::vector<std::string>& folders);

}  // namespace literate
