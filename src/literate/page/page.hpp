// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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

}  // namespace literate
