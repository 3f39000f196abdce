// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace literate {

/// The parts that a document asks for by \input or \include and that are neither in its folder, nor
/// among the generated files, nor in TeX's: each «report/a.tex:line:column: there is no file
/// 'name'», with the nearest name of a part. Names that a macro makes are left to LaTeX. Throws
/// sys::OutputError if the folder or a file cannot be read.
std::vector<std::string> missing_inputs(const std::filesystem::path& folder,
                                        const std::filesystem::path& generated);

}  // namespace literate
