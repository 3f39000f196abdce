// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "literate/page/expansion.hpp"

namespace literate {

struct Page {
  std::string html;
  std::string title, date, description;  ///< plain text, as the page shows them
  std::vector<std::string> authors;      ///< their names alone
  std::vector<std::string> figures;      ///< registered ones that it shows, as figures/NAME.svg
  std::vector<std::string> pictures;     ///< others, as the document names them
  std::vector<std::string> typeset;      ///< LaTeX of those that become figures/typeset-N.svg
  /// «file:line:column: what the page cannot show», in the order of the text.
  std::vector<std::string> errors;
};

/// Writes the document as one HTML page, without its look, data and drawings.
///
/// The document's own commands and those of the engine are expanded, pandoc reads the rest, and all
/// numbers are those of the PDF. In the preamble, only definitions count; in the text, what neither
/// knows is an error. A file page.tex beside the main file is read after the preamble and may
/// define for the page what packages define for LaTeX; \LiteratePicture{environment} there has
/// LaTeX set each of these as a picture. Throws sys::InputError if the PDF is of another state of
/// the document, sys::OutputError for a file that cannot be read, and sys::ToolError if pandoc
/// fails.
Page write_page(const PageSources& sources);

/// Writes what the page's script knows of the document, as JSON that may stand in a script element
/// of HTML: every «<» is escaped.
///
/// - `values`, by key: printed text, unrounded number, bound of its error in the unit of the
///   number, unit, line of code;
/// - `figures` and `tables`, by name: line of code, data files with their bytes, and of figures the
///   script as it was drawn and what its panels show, for readers who point at it;
/// - `style`: the script that all figures share.
///
/// `generated` is the folder that `compute` and `draw` wrote. What gnuplot tells of a figure is
/// kept in the folder `kept`, and asked for again when the figure is drawn from something else.
/// Throws sys::OutputError for a file that is missing or malformed.
std::string page_data(const std::filesystem::path& generated, const std::filesystem::path& kept);

}  // namespace literate
