// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace literate {

/// Escapes plain UTF-8 text so that LaTeX prints it character by character: neither commands nor
/// ligatures such as -- or ?` are left. Characters beyond ASCII stay as they are; pdfLaTeX knows
/// the accented letters and typographic signs among them. Control characters become blanks.
std::string latex_escaped(std::string_view text);

/// Returns LaTeX that an author wrote, fit to stand between what the engine writes. A % that is not
/// escaped is, since a text of a program has no comments: «share in %» prints its sign. Throws
/// std::invalid_argument for braces that do not match, and for a text that is not UTF-8.
std::string author_latex(std::string_view latex);

/// Throws std::invalid_argument for a text that is not UTF-8.
void require_utf8(std::string_view text);

}  // namespace literate
