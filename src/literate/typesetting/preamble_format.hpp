// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "literate/typesetting/latex_run.hpp"

namespace literate {

/// What TeX knows after a document's preamble, kept as a format that pdfTeX starts from: a pass is
/// shorter by the time that the preamble takes, and makes the same bytes.
struct PreambleFormat {
  std::filesystem::path folder;  ///< holds preamble.fmt, and the log of the run that made it
  bool is_usable = false;        ///< false: LaTeX has to read the preamble in each pass
  bool is_new = false;           ///< whether it was made, or given up, by this call
};

/// Makes the format anew if anything that the preamble reads is another than it was, or a TeX file
/// came to the folders that it reads from or went from there; also if the format is not the one
/// that was made, as after an interruption.
///
/// Some preambles cannot be kept: those with an error, those that open a file for writing or read
/// what an earlier pass wrote, and those that end elsewhere than at the beginning of a line of the
/// main file. Such a document is typeset without a format, which also tells the errors. Throws
/// sys::ToolError if there is no pdflatex and sys::OutputError for a folder that cannot be written.
PreambleFormat keep_preamble(const TypesetOptions& options);

}  // namespace literate
