// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "literate/document/document.hpp"
#include "literate/imports/import_json.hpp"

namespace literate {

/// Registers a CSV file that another program wrote as a table.
///
/// The first line holds the headings, each with its unit in parentheses behind it: «x (in)». A
/// column whose heading is abs_error holds the error bounds of the column to its left and is not
/// printed itself; so do two with the headings below and above, and standard holds standard
/// uncertainties. Numbers without such a column are refused, unless `options.exact` has its
/// heading as the file writes it, with its unit. Each number keeps the digits of the file as far as
/// its error supports them, or is printed with its error, if `options.uncertain` has its heading. A
/// column without any number, or in `options.text`, is one of texts, and headings are plain text.
///
/// File and script are attached to the document and are the table's source place. Throws
/// ImportError, «file:line:column: table 'name': what is wrong» where column counts characters: for
/// what csv_rows and table_of refuse, a name that is malformed or registered already, a heading
/// that stands twice, an abs_error without a column to its left or misspelt, and a heading in
/// `options` that the file has not.
void import_csv(Document& document, const std::string& name, const std::filesystem::path& file,
                const std::filesystem::path& script, const ImportOptions& options = {});

}  // namespace literate
