// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/excerpts/excerpt_hashes.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "system/error.hpp"
#include "system/files.hpp"

namespace literate {
namespace {

[[noreturn]] void refuse(std::string_view file, std::string_view name) {
  throw sys::SourceError(fmt::format(
      "{}: excerpt '{}' is not what this program was compiled from: rebuild", file, name));
}

}  // namespace

std::string excerpt_hashes_source(const std::vector<Excerpt>& excerpts, std::string_view space) {
  std::string entries;
  for (const Excerpt& excerpt : excerpts) {
    entries += fmt::format("    {{R\"text({})text\", R\"text({})text\", \"{}\"}},\n", excerpt.name,
                           excerpt.file, sys::sha256_of_text(excerpt.text));
  }
  return fmt::format(
      "// Written by the build.\n"
      "#include \"literate/excerpts/excerpt_hashes.hpp\"\n\n"
      "namespace {0} {{\n\n"
      "extern const std::vector<literate::CompiledExcerpt> compiled_excerpts;\n"
      "const std::vector<literate::CompiledExcerpt> compiled_excerpts = {{\n{1}}};\n\n"
      "}}  // namespace {0}\n",
      space, entries);
}

void require_compiled(const std::vector<Excerpt>& excerpts,
                      const std::vector<CompiledExcerpt>& compiled) {
  for (const Excerpt& excerpt : excerpts) {
    const auto known = std::ranges::find(compiled, excerpt.name, &CompiledExcerpt::name);
    const bool is_same = known != compiled.end() && known->file == excerpt.file &&
                         known->sha256 == sys::sha256_of_text(excerpt.text);
    if (!is_same) refuse(excerpt.file, excerpt.name);
  }
  for (const CompiledExcerpt& known : compiled) {
    if (std::ranges::find(excerpts, known.name, &Excerpt::name) == excerpts.end()) {
      refuse(known.file, known.name);
    }
  }
}

}  // namespace literate
