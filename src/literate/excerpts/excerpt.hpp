// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace literate {

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

}  // namespace literate
