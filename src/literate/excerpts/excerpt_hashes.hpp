// SPDX-License-Identifier: GPL-3.0-or-later
// Which excerpts a program was compiled from, so that one that is out of date is not believed.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "literate/excerpts/excerpt.hpp"

namespace literate {

/// An excerpt as it was when the program was compiled.
struct CompiledExcerpt {
  std::string_view name;
  std::string_view file;    ///< relative to the source root
  std::string_view sha256;  ///< of the text between the markers
};

/// A C++ source that defines `const std::vector<CompiledExcerpt> compiled_excerpts` in the given
/// namespace: what a build writes from the excerpts it is about to compile.
std::string excerpt_hashes_source(const std::vector<Excerpt>& excerpts, std::string_view space);

/// Throws sys::SourceError naming the file and the first excerpt that differs from the one
/// compiled, moved to another file, came or went since.
void require_compiled(const std::vector<Excerpt>& excerpts,
                      const std::vector<CompiledExcerpt>& compiled);

}  // namespace literate
