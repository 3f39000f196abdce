// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "literate/typesetting/typeset_options.hpp"

namespace literate {

/// Typesets a document with latexmk, which runs pdflatex as often as the references need, starting
/// from the preamble as keep_preamble keeps it.
///
/// The output does not depend on date, time zone, locale, folder or the user's settings of latexmk;
/// its bytes are the same each time if the document sets \pdfinfoomitdate=1, \pdftrailerid{} and
/// \pdfsuppressptexinfo=-1. The output is written beside its place and renamed, or left untouched
/// if its bytes are the same. Throws sys::ToolError if latexmk or pdflatex is missing (it names
/// `make setup`), with «file:line: message» for LaTeX's errors, and with all latex_defects if there
/// are any; with_place_of_use rewrites these messages. Throws sys::OutputError if the output or the
/// build folder cannot be written.
void typeset(const TypesetOptions& options);

}  // namespace literate
