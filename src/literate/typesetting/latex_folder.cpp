// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/typesetting/latex_folder.hpp"

#include "system/files.hpp"
#include "system/record.hpp"

namespace literate {
namespace fs = std::filesystem;
namespace {

constexpr const char* record_name = "as-left.sha256";

}  // namespace

LatexFolder::LatexFolder(const TypesetOptions& options)
    : folder_(options.build_dir),
      stem_(fs::path(options.main_file).filename().replace_extension().string()) {}

bool LatexFolder::is_as_left() const {
  const fs::path record = folder_ / record_name;
  return fs::is_regular_file(record) && sys::read_file(record) == digests();
}

void LatexFolder::clear() const {
  begin();
  for (const std::string& file : files()) sys::remove_file(folder_ / file);
}

void LatexFolder::begin() const {
  sys::remove_file(folder_ / record_name);
}

void LatexFolder::keep() const {
  sys::write_file_atomically(folder_ / record_name, digests());
}

// Those that bear the document's name, and the .aux files of its parts. A folder that is the
// author's own may hold sources of the same name.
std::vector<std::string> LatexFolder::files() const {
  static const std::vector<std::string> sources = {".tex", ".bib", ".sty", ".cls", ".bst"};
  std::vector<std::string> files = sys::files_below(folder_);
  std::erase_if(files, [&](const std::string& file) {
    const bool is_made_for_it = file.starts_with(stem_ + ".") || file.ends_with(".aux");
    for (const std::string& ending : sources) {
      if (file.ends_with(ending)) return true;
    }
    return !is_made_for_it || file.starts_with("preamble/") || file.starts_with("at-width/");
  });
  return files;
}

std::string LatexFolder::digests() const {
  return sys::record_text(sys::record_entries(folder_, files()));
}

}  // namespace literate
