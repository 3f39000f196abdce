// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace literate {

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
