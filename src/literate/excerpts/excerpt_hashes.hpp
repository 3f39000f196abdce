// SPDX-License-Identifier: GPL-3.0-or-later
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

/// Writes a C++ source that defines `const std::vector<CompiledExcerpt> compiled_excerpts` in the
/// given namespace. The build compiles it into the program together with the excerpts themselves.
std::string excerpt_hashes_source(const std::vector<Excerpt>& excerpts, std::string_view space);

/// Throws sys::SourceError naming the first excerpt, and its file, that was changed, moved to
/// another file, added or removed since the program was compiled: a listing of newer sources would
/// not belong to the numbers beside it.
void require_compiled(const std::vector<Excerpt>& excerpts,
                      const std::vector<CompiledExcerpt>& compiled);

}  // namespace literate
