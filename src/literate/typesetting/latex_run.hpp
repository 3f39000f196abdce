// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

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
  std::string scripts_label = "figures";      ///< what messages call the folder of their scripts
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

}  // namespace literate
