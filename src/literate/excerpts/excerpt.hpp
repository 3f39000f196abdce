// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace literate {

/// Lines of a source file between two markers, each on a line of its own:
/// «begin excerpt: name» and «end excerpt: name» behind a comment leader, two slashes, # or %.
struct Excerpt {
  std::string name;
  std::string file;    ///< relative to the source root, with slashes
  int first_line = 0;  ///< of the text, the marker not counted
  std::string text;    ///< without the blank lines at its ends; each line ends in '\n'
};

int last_line(const Excerpt& excerpt);

/// Finds the excerpts of one file's text, in the order of the file. Throws sys::SourceError
/// «file:line: message» for a marker that is malformed, unclosed, unmatched, nested or doubled,
/// for an excerpt with no text, and for a character that LaTeX has no mapping for.
std::vector<Excerpt> excerpts_of(std::string_view text, const std::string& file);

/// Finds the excerpts of all *.cpp and *.hpp files below the given folders of `source_root`, sorted
/// by name. Throws sys::SourceError as excerpts_of does, for a name marked in two files, and for a
/// folder that does not exist.
std::vector<Excerpt> find_excerpts(const std::filesystem::path& source_root,
                                   const std::vector<std::string>& folders);

/// Writes folder/name.cpp, the code with its common indentation removed, and folder/name.tex, the
/// listing with its true line numbers.
void write_excerpt(const std::filesystem::path& folder, const Excerpt& excerpt);

}  // namespace literate
