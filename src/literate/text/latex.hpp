// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace literate {

/// Escapes plain UTF-8 text so that LaTeX prints it character by character, without commands and
/// without ligatures such as -- or ?`. Characters beyond ASCII stay; pdfLaTeX knows the accented
/// letters and typographic signs among them. Control characters become blanks.
std::string latex_escaped(std::string_view text);

/// Makes an author's LaTeX safe to embed in the engine's files. It escapes a bare %, since a text
/// in a program has no comments: «share in %» prints the sign. Throws std::invalid_argument for
/// unmatched braces, a backslash at the end, and a text that is not UTF-8.
std::string author_latex(std::string_view latex);

/// Throws std::invalid_argument for a text that is not UTF-8.
void require_utf8(std::string_view text);

}  // namespace literate
