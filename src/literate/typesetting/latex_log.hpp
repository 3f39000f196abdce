// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace literate {

/// The errors of a LaTeX log written with -file-line-error: each «file:line: message», followed by
/// the line that shows the place («l.12 …»). Empty if there is none. Files below the working
/// directory of LaTeX are named `source_label`/file.
std::vector<std::string> latex_errors(std::string_view log, std::string_view source_label);

/// What a finished document must not have: undefined references and citations, labels defined
/// twice, missing characters, boxes overfull by more than 0.1 pt. Each with file and line as far as
/// the log tells. The log must be unwrapped (max_print_line).
std::vector<std::string> latex_defects(std::string_view log, std::string_view source_label);

}  // namespace literate
