// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <set>
#include <string>

#include "literate/document/document.hpp"

namespace literate {

/// Where an imported file belongs.
struct ImportOptions {
  std::filesystem::path root = ".";  ///< the checkout; places are told relative to it
  std::string prefix = {};           ///< put before each key of a value and each name of a table
  // Headings of a CSV file, of columns
  std::set<std::string> exact = {};      ///< whose numbers have no error
  std::set<std::string> uncertain = {};  ///< whose numbers are printed as uncertain() does
  std::set<std::string> text = {};       ///< that hold texts, although they may look like numbers
};

/// Registers the values and tables that another program (Octave, Python, Fortran …) wrote as JSON.
///
/// results.schema.json beside this header says what the file holds: the script, relative to it, and
/// perhaps the script's SHA-256 when it ran, as numbers older than it are refused; values by their
/// keys, {"value": 1.2e-6, "abs_error": 1e-14, "unit": "in", "digits": 8} or {"text": "7.3.0"};
/// tables by their names, {"columns": [{"heading": "$x$", "decimals": 3}, …], "rows": [[…], …]}.
/// A number has a bound of its error, 0 for what is exact, or a standard uncertainty, or both,
/// unless its column is of integers or exact. It prints the digits that are asked for, which the
/// error has to support, and otherwise those that it supports.
///
/// The file and its script are attached to the document, and are the source place of each value and
/// table. Throws ImportError, «file:line:column: what is wrong», for anything else: bad JSON, a key
/// twice, an unknown or missing field, a number that is not finite (also as null), one without its
/// error, digits that the error does not support, a unit that cannot be printed, a key or name that
/// is malformed or registered already, a script that cannot be read or has changed since. Nothing
/// is registered then.
void import_json(Document& document, const std::filesystem::path& file,
                 const ImportOptions& options = {});

}  // namespace literate
