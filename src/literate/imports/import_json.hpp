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
  std::set<std::string> exact = {};  ///< headings of a CSV file whose numbers have no error
};

/// Registers the values and tables that another program (Octave, Python, Fortran …) wrote as JSON.
///
/// The file is an object with these fields; results.schema.json beside this header says the same
/// for machines.
///
///   "script"         the program's source, relative to the JSON file; required
///   "script_sha256"  the SHA-256 of the script when it ran; numbers older than it are refused
///   "values"         an object; each field is a value, and its name is the key:
///       {"value": 1.2e-6, "abs_error": 1e-14, "unit": "in", "digits": 8}   or   {"text": "7.3.0"}
///     abs_error, a bound, is required, 0 for what is exact; or else standard, an uncertainty, or
///     both. With digits, so many significant ones are printed, and the error has to support them;
///     without, those are printed that it supports.
///   "tables"         an object; each field is a table:
///       {"columns": [{"heading": "$x$", "unit": "in", "decimals": 3}, …], "rows": [[0.005, …], …]}
///     A column has a heading (LaTeX) and prints by decimals (with exponent: of the number divided
///     by 10^exponent), digits, integer: true or text: true; without any of them each number keeps
///     the digits of the file as far as its error supports them. A cell is a text, null or
///     {"value": …, "abs_error": …, "standard": …}, or a bare number where the column is of
///     integers or says exact: true.
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
