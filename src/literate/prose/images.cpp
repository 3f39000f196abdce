// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/prose/images.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <set>

#include "literate/prose/document_files.hpp"
#include "literate/prose/source_label.hpp"
#include "literate/prose/tex_commands.hpp"
#include "system/files.hpp"

namespace literate {
namespace fs = std::filesystem;
namespace {

/// Why a file cannot be a picture of the document; empty if it can.
std::string fault_of_image(const fs::path& source_dir, const std::string& name) {
  static const std::set<std::string> endings = {".png", ".jpg", ".jpeg", ".pdf"};
  const fs::path file = fs::path(name).lexically_normal();
  if (file.is_absolute() || *file.begin() == "..") {
    return "lies outside the document's folder, where nobody else has it";
  }
  if (!endings.contains(file.extension())) return "is no .png, .jpg or .pdf file by its name";
  if (!fs::is_regular_file(source_dir / file)) return "is not there";
  return "";
}

}  // namespace

Images images_of(const fs::path& source_dir) {
  Images images;
  std::set<std::string> found;
  for (const std::string& file : document_files(source_dir)) {
    const std::string text = sys::read_file(source_dir / file);
    for (const TexCommand& use : commands_in(text, {"image", "includegraphics"})) {
      const std::string fault = fault_of_image(source_dir, use.argument);
      if (fault.empty()) {
        found.insert(fs::path(use.argument).lexically_normal().generic_string());
      } else if (use.name == "image") {
        images.errors.push_back(fmt::format("{}/{}:{}:{}: picture '{}' {}",
                                            source_label(source_dir), file, use.line, use.column,
                                            use.argument, fault));
      }
    }
  }
  images.files.assign(found.begin(), found.end());
  return images;
}

}  // namespace literate
