// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/excerpts/paper_sources.hpp"

#include <algorithm>

#include "system/files.hpp"

namespace literate {

std::vector<std::string> paper_sources(const std::filesystem::path& folder) {
  constexpr std::string_view list = "/CMakeLists.txt";
  std::vector<std::string> files = sys::files_below(folder);
  std::vector<std::string> others;
  for (const std::string& file : files) {
    if (!file.ends_with(list)) continue;
    if (sys::read_file(folder / file).find("\nliterate_add_paper(") == std::string::npos) continue;
    others.push_back(file.substr(0, file.size() - list.size() + 1));
  }
  std::erase_if(files, [&](const std::string& file) {
    return std::ranges::any_of(others, [&](const auto& other) { return file.starts_with(other); });
  });
  return files;
}

}  // namespace literate
