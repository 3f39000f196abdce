// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace literate {

/// Finds what cannot be an option of \fig[width=…]{name} in a document: another option than width,
/// or a width that is neither a number with a unit nor holds a length of LaTeX. Each is
/// «file:line:column: message». What a length of LaTeX amounts to is known to LaTeX alone, which
/// refuses less than 1 cm and more than the paper. Throws sys::OutputError if the document cannot
/// be read.
std::vector<std::string> figure_width_errors(const std::filesystem::path& source_dir);

}  // namespace literate
