// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace literate {

/// The parts that a document asks for by \input or \include and that are neither in its folder, nor
/// among the generated files, nor in TeX's: each «report/a.tex:line:column: there is no file
/// 'name'», with the nearest name of a part; and bibliographies likewise, unless the document
/// brings the references as a .bbl. Names that a macro makes are left to LaTeX. Throws
/// sys::OutputError if the folder or a file cannot be read.
std::vector<std::string> missing_inputs(const std::filesystem::path& folder,
                                        const std::filesystem::path& generated);

/// The parts and files that would take the place of others without a word: an \input of the page's
/// own preamble, whose changes do not typeset the document again, and files of the document's
/// folder that bear the name of one of the `generated` files, which TeX would not find. Each is one
/// line.
std::vector<std::string> misplaced_files(const std::filesystem::path& folder,
                                         const std::vector<std::string>& generated);

}  // namespace literate
