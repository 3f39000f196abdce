// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace literate {

/// Finds the errors in a LaTeX log that was written with -file-line-error: each «file:line:
/// message», followed by what TeX had just read if that is not to be seen in the line that shows
/// the place («<recently read> \foo»), and by that line («l.12 …»). Files below the folder in which
/// LaTeX runs are named `source_label`/file.
std::vector<std::string> latex_errors(std::string_view log, std::string_view source_label);

/// Finds what a finished document must not have: undefined references and citations, labels defined
/// twice, missing characters, floats that are too large for a page, and boxes that are overfull by
/// more than 0.1 pt, or 3 pt around the page. Each has its file and line if the log names them. The
/// log's lines must not be wrapped (max_print_line).
std::vector<std::string> latex_defects(std::string_view log, std::string_view source_label);

/// The line in which LaTeX or a package asks for another run; empty if none does.
std::string rerun_request(std::string_view log);

/// The errors in a .blg file of BibTeX, each «report/file.bib:line: BibTeX: message»; without a
/// place where BibTeX tells only that of a file of LaTeX's own.
std::vector<std::string> bibtex_errors(std::string_view log, std::string_view source_label);

/// Whether a defect is a box that is overfull, which an author who is writing may leave for later.
bool is_overfull_box(std::string_view defect);

}  // namespace literate
