// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/excerpts/excerpt.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <limits>
#include <map>

#include "literate/excerpts/paper_sources.hpp"
#include "literate/text/latex.hpp"
#include "system/error.hpp"
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

bool is_source(const std::string& file) {
  return file.ends_with(".cpp") || file.ends_with(".hpp");
}

}  // namespace

int last_line(const Excerpt& excerpt) {
  return excerpt.first_line + static_cast<int>(std::ranges::count(excerpt.text, '\n')) - 1;
}

std::vector<Excerpt> find_excerpts(const fs::path& source_root,
                                   const std::vector<std::string>& folders) {
  std::map<std::string, Excerpt> by_name;
  for (const std::string& folder : folders) {
    if (!fs::is_directory(source_root / folder)) {
      throw sys::SourceError(fmt::format("{}: there is no such folder to take excerpts from",
                                         (source_root / folder).generic_string()));
    }
    for (const std::string& file : paper_sources(source_root / folder)) {
      if (!is_source(file)) continue;
      const std::string text = sys::read_file(source_root / folder / file);
      for (Excerpt& excerpt : excerpts_of(text, fmt::format("{}/{}", folder, file))) {
        const auto [known, is_new] = by_name.try_emplace(excerpt.name, excerpt);
        if (!is_new) {
          throw sys::SourceError(fmt::format("{}:{}: excerpt '{}' is marked at {}:{} already",
                                             excerpt.file, excerpt.first_line - 1, excerpt.name,
                                             known->second.file, known->second.first_line - 1));
        }
      }
    }
  }
  std::vector<Excerpt> excerpts;
  for (auto& [name, excerpt] : by_name) excerpts.push_back(std::move(excerpt));
  return excerpts;
}

void write_excerpt(const fs::path& folder, const Excerpt& excerpt) {
  sys::write_file_atomically(folder / (excerpt.name + ".cpp"),
                             without_common_indentation(excerpt.text));
  sys::write_file_atomically(
      folder / (excerpt.name + ".tex"),
      fmt::format("\\LiterateListing{{{}}}{{{}}}{{{}}}{{{}}}\n", excerpt.name,
                  escape_latex_path(excerpt.file), excerpt.first_line, last_line(excerpt)));
}

}  // namespace literate
