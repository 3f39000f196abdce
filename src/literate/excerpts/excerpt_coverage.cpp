// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/excerpts/excerpt_coverage.hpp"

#include <algorithm>
#include <string_view>

#include "system/files.hpp"
#include "system/lines.hpp"

namespace literate {
namespace {

int lines_of_code(std::string_view text) {
  int count = 0;
  for (const std::string_view line : sys::lines_of(text)) {
    const std::size_t first = line.find_first_not_of(" \t");
    if (first == std::string_view::npos) continue;
    const std::string_view code = line.substr(first);
    if (!code.starts_with("//") && !code.starts_with("#")) ++count;
  }
  return count;
}

}  // namespace

ExcerptCoverage coverage_of(const std::filesystem::path& source_root, const std::string& folder,
                            const std::vector<Excerpt>& excerpts) {
  ExcerptCoverage coverage;
  for (const std::string& file : sys::files_below(source_root / folder)) {
    if (!file.ends_with(".cpp")) continue;
    coverage.n_lines += lines_of_code(sys::read_file(source_root / folder / file));
    int n_shown = 0;
    for (const Excerpt& excerpt : excerpts) {
      if (excerpt.file == folder + "/" + file) n_shown += lines_of_code(excerpt.text);
    }
    coverage.n_shown += n_shown;
    if (n_shown == 0) coverage.rest.push_back(file);
  }
  std::ranges::sort(coverage.rest);
  return coverage;
}

}  // namespace literate
