// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace literate {

/// The LaTeX files of the document in a folder: all *.tex in it and below, sorted, as generic paths
/// relative to it; without those of folders below that hold a document (a \documentclass) of their
/// own. Throws sys::OutputError.
std::vector<std::string> document_files(const std::filesystem::path& source_dir);

}  // namespace literate
