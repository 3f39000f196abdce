// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/prose/document_files.hpp"

#include <algorithm>

#include "system/files.hpp"
#include "system/lines.hpp"

namespace literate {
namespace {

bool begins_document(const std::filesystem::path& file) {
  return std::ranges::any_of(sys::lines_of(sys::read_file(file)), [](std::string_view line) {
    return sys::stripped(line).starts_with("\\documentclass");
  });
}

}  // namespace

std::vector<std::string> document_files(const std::filesystem::path& source_dir) {
  std::vector<std::string> files = sys::files_below(source_dir);
  std::erase_if(files, [](const std::string& file) {
    return !file.ends_with(".tex") || file == page_preamble;
  });
  std::vector<std::string> others;  // folders of other documents, each with a '/' at its end
  for (const std::string& file : files) {
    const auto slash = file.rfind('/');
    if (slash == file.npos || !begins_document(source_dir / file)) continue;
    others.push_back(file.substr(0, slash + 1));
  }
  std::erase_if(files, [&](const std::string& file) {
    return std::ranges::any_of(others, [&](const auto& other) { return file.starts_with(other); });
  });
  return files;
}

}  // namespace literate
