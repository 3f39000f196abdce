// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace literate {

/// Lists the LaTeX files of the document in a folder: all *.tex files in it and below, sorted, as
/// generic paths relative to it. A folder below that has a \documentclass holds a document of its
/// own and is left out. Throws sys::OutputError if the folder or a file cannot be read.
std::vector<std::string> document_files(const std::filesystem::path& source_dir);

}  // namespace literate
