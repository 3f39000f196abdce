// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/excerpts/excerpt.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <limits>

#include "literate/excerpts/listing_language.hpp"
#include "literate/text/latex.hpp"
#include "system/files.hpp"
#include "system/lines.hpp"

namespace literate {
namespace fs = std::filesystem;
namespace {

/// Removes the indentation that all lines share, so that the listing starts at the margin.
std::string without_common_indentation(const std::string& text) {
  std::size_t indentation = std::numeric_limits<std::size_t>::max();
  for (const std::string_view line : sys::lines_of(text)) {
    const auto first = line.find_first_not_of(' ');
    if (first != std::string_view::npos) indentation = std::min(indentation, first);
  }
  std::string result;
  for (const std::string_view line : sys::lines_of(text)) {
    result.append(line.substr(std::min(indentation, line.size()))).append("\n");
  }
  return result;
}

}  // namespace

int last_line(const Excerpt& excerpt) {
  return excerpt.first_line + static_cast<int>(std::ranges::count(excerpt.text, '\n')) - 1;
}

void write_excerpt(const fs::path& folder, const Excerpt& excerpt) {
  sys::write_file_atomically(folder / (excerpt.name + ".txt"),
                             without_common_indentation(excerpt.text));
  sys::write_file_atomically(
      folder / (excerpt.name + ".tex"),
      fmt::format("\\LiterateListing{{{}}}{{{}}}{{{}}}{{{}}}{{{}}}\n", excerpt.name,
                  escape_latex_path(excerpt.file), excerpt.first_line, last_line(excerpt),
                  listing_language(excerpt.file)));
}

}  // namespace literate
