// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace literate {

/// The file beside the main one that is read for the page alone, and so is no part of the document.
inline constexpr std::string_view page_preamble = "page.tex";

/// Lists the LaTeX files of the document in a folder: all *.tex files in it and below but for the
/// page's, sorted, as generic paths relative to it. A folder below that has a \documentclass holds
/// a document of its own and is left out. Throws sys::OutputError if the folder or a file cannot be
/// read.
std::vector<std::string> document_files(const std::filesystem::path& source_dir);

}  // namespace literate
