// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "literate/prose/tex_scanner.hpp"

namespace literate {

/// A LaTeX text of which only the prose and the mathematics are left.
struct Prose {
  /// These stand where a command was: one that sets upright letters, a number with its unit, a
  /// \cite, the sign of a unit.
  static constexpr char upright = '\x01';
  static constexpr char quantity = '\x02';
  static constexpr char citation = '\x03';
  static constexpr char unit_sign = '\x04';

  /// Has the length and the line ends of the LaTeX text, and blanks in place of comments, verbatim
  /// text, names of commands, arguments that are not printed (keys, labels, lengths), the list of
  /// references, and of what precedes \begin{document} all but titles and the bodies of
  /// definitions.
  std::string text;
  std::vector<TexMode> modes;  ///< one for each byte of `text`
};

/// Takes the commands of plain LaTeX, amsmath, hyperref and literate.sty out of a text.
Prose prose_of(std::string_view latex);

}  // namespace literate
