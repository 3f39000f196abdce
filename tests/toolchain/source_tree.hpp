// SPDX-License-Identifier: GPL-3.0-or-later
// The project's own files, for tests that read them.
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace source_tree {

inline const std::filesystem::path root = HALFSPACE_SOURCE_DIR;

/// The files below `folder` (relative to the project), sorted, as paths relative to the project.
inline std::vector<std::filesystem::path> files_below(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  if (!std::filesystem::exists(root / folder)) return files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(root / folder)) {
    if (entry.is_regular_file()) files.push_back(entry.path().lexically_relative(root));
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// The lines of a file given relative to the project.
inline std::vector<std::string> lines_of(const std::filesystem::path& file) {
  std::vector<std::string> lines;
  std::ifstream stream(root / file);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

inline bool is_cpp(const std::filesystem::path& file) {
  return file.extension() == ".hpp" || file.extension() == ".cpp";
}

}  // namespace source_tree
