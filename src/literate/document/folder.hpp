// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "literate/document/document.hpp"

namespace literate {

/// Writes all that LaTeX, gnuplot and the tools need of a document: values.tex, ledger.tex,
/// tables/, figures/, values.csv, claims.csv, tables.csv, and results.json last.
///
/// Everything is put together in memory before the first file is written. A file whose content is
/// the same keeps its time stamp. Files that the results.json of an earlier run lists and this run
/// does not write are removed; any other file, such as a drawing, is left alone. `case_name` is
/// what `\papercase` prints. Throws sys::OutputError for a folder that cannot be written.
void write_folder(const Document& document, const std::filesystem::path& folder,
                  const std::string& case_name);

}  // namespace literate
