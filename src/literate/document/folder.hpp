// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "literate/document/document.hpp"

namespace literate {

/// Writes the files of a document for LaTeX, gnuplot and the tools: values.tex, ledger.tex,
/// tables/, figures/, values.csv, claims.csv, tables.csv, and results.json last.
///
/// It assembles all files in memory before it writes the first. A file with unchanged content keeps
/// its time stamp. Files listed in an earlier results.json that this run does not write are
/// removed; all other files, such as drawings, stay. `\papercase` prints `case_name`. Throws
/// sys::OutputError if the folder cannot be written.
void write_folder(const Document& document, const std::filesystem::path& folder,
                  const std::string& case_name);

}  // namespace literate
