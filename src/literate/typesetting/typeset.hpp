// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace literate {

/// A LaTeX document and where its parts lie.
struct TypesetOptions {
  std::filesystem::path source_dir;     ///< the folder LaTeX runs in
  std::string main_file;                ///< relative to source_dir, such as "report.tex"
  std::filesystem::path generated_dir;  ///< what Document::write made
  std::filesystem::path build_dir;      ///< for LaTeX's own files; made if it does not exist
  std::filesystem::path output_pdf;     ///< the finished document
  std::int64_t source_date_epoch = 0;   ///< the date that \today prints, in seconds
};

/// Typesets a document with latexmk and pdflatex, as often as its references need.
///
/// The output does not depend on date, time zone, locale, user settings of latexmk, or folder; for
/// the same bytes the document itself sets \pdfinfoomitdate=1, \pdftrailerid{} and
/// \pdfsuppressptexinfo=-1. The output is written beside its place and renamed, and left untouched
/// if its bytes are the same. Throws sys::ToolError if latexmk or pdflatex is missing (naming
/// `make setup`), with LaTeX's «file:line: message» on an error, and with all of latex_defects if
/// there is one, errors within generated files told where the document uses them; sys::OutputError
/// if the output or the build folder cannot be written.
void typeset(const TypesetOptions& options);

}  // namespace literate
