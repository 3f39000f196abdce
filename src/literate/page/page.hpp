// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace literate {

/// What a page is made of.
struct PageSources {
  std::filesystem::path document;   ///< folder of the LaTeX document
  std::string main_file;            ///< in it
  std::filesystem::path generated;  ///< what `compute` and `draw` wrote
  std::string statements = {};      ///< as write_statements makes them for LaTeX
  std::string restyled = {};        ///< as restyled_values makes them
  std::string repository = {};      ///< the state of the repository, \LiterateRepository
  /// What BibTeX makes of an .aux file: the bibliography as LaTeX.
  std::function<std::string(const std::string& aux)> bibliography = {};
};

struct Page {
  std::string html;
  std::string title, authors, date, description;  ///< plain text, as the page shows them
  std::vector<std::string> figures;   ///< registered ones that it shows, as figures/NAME.svg
  std::vector<std::string> pictures;  ///< others, as the document names them
  /// «file:line:column: what the page cannot show», in the order of the text.
  std::vector<std::string> errors;
};

/// Writes the document as one HTML page.
///
/// It reads LaTeX as far as prose uses it: the document's own commands and environments, sections,
/// lists, tables, floats, footnotes, formulas, references by \ref and cleveref, BibTeX, and all
/// commands of literate.sty. In the preamble, what it does not know is passed over; in the text it
/// is an error. A file page.tex beside the main file is read after the preamble and may define for
/// the page what packages define for LaTeX. Throws sys::OutputError for a file that cannot be read.
Page write_page(const PageSources& sources);

}  // namespace literate
