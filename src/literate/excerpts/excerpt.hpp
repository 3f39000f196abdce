// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace literate {

/// What LaTeX's package listings calls the language of a source file, by the file's name; empty for
/// a text whose language is not known, which is printed as it is. literate.sty defines those that
/// listings lacks: CMake, Julia, JSON and TOML.
std::string listing_language(std::string_view file);

/// Lines of a source file between two markers, each on a line of its own:
/// «begin excerpt: name» and «end excerpt: name» after a comment sign: // # % -- ! ; or within
/// /* */, <!-- --> or (* *).
struct Excerpt {
  std::string name;
  std::string file;    ///< relative to the source root, with slashes
  int first_line = 0;  ///< of the text, which begins after the marker
  std::string text;    ///< without the blank lines at its ends; each line ends in '\n'
};

/// The number of the last line in its file.
int last_line(const Excerpt& excerpt);

/// Writes folder/name.txt, the code with its common indentation removed, and folder/name.tex, the
/// listing with its language and true line numbers.
void write_excerpt(const std::filesystem::path& folder, const Excerpt& excerpt);

/// Finds the excerpts of one file's text, in the order of the file. Throws sys::SourceError
/// «file:line: message» for a marker that is malformed, unclosed, unmatched, nested or doubled,
/// for an excerpt without text, and for a character that latex_of has no mapping for.
std::vector<Excerpt> excerpts_of(std::string_view text, const std::string& file);

/// Finds the excerpts of all text files below the given folders of `source_root`, which may be
/// files themselves, sorted by name. Throws sys::SourceError as excerpts_of does, and for a name
/// that is marked in two files or a folder that does not exist.
std::vector<Excerpt> find_excerpts(const std::filesystem::path& source_root,
                                   const std::vector<std::string>& folders);

/// A record, line by line, of excerpts: the SHA-256 of the text and of the number of its first
/// line, which is printed, and «file: excerpt 'name'».
std::string record_of(const std::vector<Excerpt>& excerpts);

/// Throws sys::SourceError naming the first excerpt, and its file, that was changed, moved to
/// another file, added or removed since the program was compiled, from what this record has: a
/// listing of newer sources would not belong to the numbers beside it.
void require_compiled(const std::vector<Excerpt>& excerpts, std::string_view compiled);

/// All files below a folder of a paper's sources, sorted, as generic paths relative to it; without
/// those of folders below that are a paper of their own (whose CMakeLists.txt calls
/// literate_add_paper). Throws sys::OutputError.
std::vector<std::string> paper_sources(const std::filesystem::path& folder);

}  // namespace literate
