// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace literate {

/// The folder in build_dir for what was read from the prose, statements.tex, which LaTeX finds there.
inline constexpr const char* prose_folder = "prose";

/// A LaTeX document and the folders of its parts.
struct TypesetOptions {
  std::filesystem::path source_dir;           ///< the folder in which LaTeX runs
  std::string main_file;                      ///< relative to source_dir, such as "report.tex"
  std::filesystem::path generated_dir;        ///< the folder that Document::write made
  std::filesystem::path repository_dir = {};  ///< of repository.tex; empty if nothing is known
  std::filesystem::path build_dir;            ///< for LaTeX's own files; made if it is missing
  std::filesystem::path output_pdf;           ///< the finished document
  std::int64_t source_date_epoch = 0;         ///< the date that \today prints, in seconds
};

/// Typesets a document with latexmk, which runs pdflatex as often as the references need, starting
/// from the preamble as keep_preamble keeps it.
///
/// The output does not depend on date, time zone, locale, folder or the user's settings of latexmk;
/// its bytes are the same each time if the document sets \pdfinfoomitdate=1, \pdftrailerid{} and
/// \pdfsuppressptexinfo=-1. The output is written beside its place and renamed, or left untouched
/// if its bytes are the same. Throws sys::ToolError if latexmk or pdflatex is missing (it names
/// `make setup`), with «file:line: message» for LaTeX's errors, and with all latex_defects if there
/// are any; with_place_of_use rewrites these messages. Throws sys::OutputError if the output or the
/// build folder cannot be written.
void typeset(const TypesetOptions& options);

}  // namespace literate
