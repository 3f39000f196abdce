// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace literate {

/// Escapes plain UTF-8 text for LaTeX. Symbols such as ν or ≤ become \ensuremath{…}, characters
/// that latex_of does not know stay as they are, and control characters become spaces.
std::string escape_latex(std::string_view text);

/// The first character of plain UTF-8 text that is not printed as it is: one beyond ASCII that
/// latex_of does not know, a byte that is no UTF-8, or a control character. Empty if there is none.
std::string_view first_unprintable(std::string_view text);

/// Escapes plain text for a PDF bookmark: characters beyond ASCII stay as they are.
std::string escape_bookmark(std::string_view text);

/// Escapes a file path and lets LaTeX break it after a slash.
std::string escape_latex_path(std::string_view path);

/// What a reader of LaTeX reads, as plain text: «θ» for `$\theta$`. LaTeX with a command that has
/// no character stays as it is.
std::string plain_text(std::string_view latex);

/// The texts of literate.sty, keep_preamble.tex and contents_decide.pl, which the build puts into
/// the library.
extern const std::string_view literate_sty, keep_preamble_tex, contents_decide_pl;

}  // namespace literate
