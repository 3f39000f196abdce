// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace literate {

/// The pictures that a document shows and no program made.
struct Images {
  std::vector<std::string> files;   ///< sorted, relative to the document's folder
  std::vector<std::string> errors;  ///< «file:line:column: message» for each that is not there
};

/// Finds the pictures of \image[…]{file.png} in a document: files of PNG, JPEG or PDF by their whole
/// names, from the document's folder on and not above it. Those of \includegraphics count if there
/// is a file of exactly this name. Throws sys::OutputError if the document cannot be read.
Images images_of(const std::filesystem::path& source_dir);

}  // namespace literate
