// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "literate/figures/draw.hpp"

namespace literate {

/// A LaTeX document and the folders of its parts.
struct TypesetOptions {
  std::filesystem::path source_dir;           ///< the folder in which LaTeX runs
  std::string main_file;                      ///< relative to source_dir, such as "report.tex"
  std::filesystem::path generated_dir;        ///< the folder that Document::write made
  std::filesystem::path repository_dir = {};  ///< of repository.tex; empty if nothing is known
  std::filesystem::path build_dir;            ///< for LaTeX's own files; made if it is missing
  std::filesystem::path output_pdf;           ///< the finished document
  std::int64_t source_date_epoch = 0;         ///< the date that \today prints, in seconds
  std::string engine = "pdflatex";            ///< or "lualatex"
  FigurePlaces figures = {};                  ///< which may be drawn at other widths
  std::filesystem::path scripts = "figures";  ///< the folder of their scripts
  bool tolerates_overfull = false;            ///< whether overfull boxes are warnings only
};

/// The folder of the figures that are drawn at a width of the document.
inline std::filesystem::path at_width_dir(const TypesetOptions& options) {
  return options.build_dir / "at-width";
}

/// The path relative to the folder in which LaTeX runs, so that its output names no folder of this
/// machine.
std::string seen_from(const std::filesystem::path& source_dir, const std::filesystem::path& path);

/// The variables by which a run depends on nothing of this machine and day: date, time zone,
/// locale, no packages of the user's; and where the generated files are found.
std::map<std::string, std::string> latex_environment(const TypesetOptions& options);

/// A file that LaTeX makes of the document, by its extension such as ".log".
std::filesystem::path in_build_dir(const TypesetOptions& options, const char* extension);

/// Whether what LaTeX left in the folder `at` was made there and of this document: its recorder
/// names both. After a move it names the former places.
bool was_made_here(const TypesetOptions& options, const std::filesystem::path& at);

/// The files that LaTeX read and wrote itself, by their names from the document's folder on, as its
/// recorder in the folder `at` tells; none if it left nothing there.
std::set<std::string> files_read(const TypesetOptions& options, const std::filesystem::path& at);

/// Throws sys::InputError for the files of an author that LaTeX read from outside the document's
/// folder, the build's and TeX's own, each with the place in the document that names it: no build
/// would see them change.
void require_read_within(const TypesetOptions& options);

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

/// What came with a document that was typeset.
struct Typeset {
  std::vector<std::string> drawn;     ///< figures at widths of its own, relative to at_width_dir()
  std::vector<std::string> warnings;  ///< the defects that were tolerated
};

/// Typesets a document with latexmk, which runs pdflatex as often as the references need, starting
/// from the preamble as keep_preamble keeps it (not so lualatex, which cannot). Draws the figures
/// that the document wants at a width of its own, as LaTeX tells it, and runs LaTeX again where one
/// was not there yet.
///
/// The output does not depend on date, time zone, locale, folder or the user's settings of latexmk;
/// its bytes are the same each time. The output is written beside its place and renamed, or left
/// untouched if its bytes are the same. Throws sys::ToolError if latexmk or the engine is missing,
/// with «file:line: message» for LaTeX's errors, and with all latex_defects if there are any;
/// with_place_of_use rewrites these messages. Throws sys::InputError as require_read_within() does,
/// and sys::OutputError if the output or the build folder cannot be written.
Typeset typeset(const TypesetOptions& options);

}  // namespace literate
