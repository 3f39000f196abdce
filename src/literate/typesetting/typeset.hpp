// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "literate/typesetting/latex_run.hpp"

namespace literate {

/// What came with a document that was typeset.
struct Typeset {
  std::vector<std::string> drawn;     ///< figures at widths of its own, relative to at_width_dir()
  std::vector<std::string> warnings;  ///< the defects that were tolerated
};

/// Typesets a document with latexmk, which runs pdflatex as often as the references need, starting
/// from the preamble as keep_preamble keeps it (not so lualatex, which cannot). Draws the figures
/// that the document wants at a width of its own, as LaTeX tells it, and runs LaTeX again where one
/// was not there yet.
///
/// The output does not depend on date, time zone, locale, folder or the user's settings of latexmk;
/// its bytes are the same each time. The output is written beside its place and renamed, or left
/// untouched if its bytes are the same. Throws sys::ToolError if latexmk or the engine is missing,
/// with «file:line: message» for LaTeX's errors, and with all latex_defects if there are any;
/// with_place_of_use rewrites these messages. Throws sys::InputError as require_read_within() does,
/// and sys::OutputError if the output or the build folder cannot be written.
Typeset typeset(const TypesetOptions& options);

}  // namespace literate
