// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "literate/document/names.hpp"
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

/// Finds numbers typed into the prose of a LaTeX text where a computed value ought to stand.
///
/// A number counts as typed if a unit follows it or if it has more than two significant digits,
/// where final zeros of a whole number are not significant. Constants in displayed equations are
/// exempt, and so are a year in parentheses or after a month, the place in a source beside a \cite,
/// and lines that end in a comment «% constant: reason». Such a comment without a reason, or on a
/// line that needs none, is reported as well. Each finding is «file:line:column: message».
std::vector<std::string> typed_numbers(std::string_view latex, const std::string& file);

/// Does the same for the texts that a gnuplot script prints, and finds data that stand in the
/// script. The comment is «# constant: reason» there.
std::vector<std::string> typed_numbers_in_script(std::string_view script, const std::string& file);

/// Does the same for all *.tex files of the document in a folder and puts source_label in front of
/// their names.
/// Throws sys::OutputError if the folder or a file cannot be read.
std::vector<std::string> typed_numbers_below(const std::filesystem::path& folder);

/// The same of the program's own texts that reach the document: a number that is typed there is
/// told with the line of the program that registered it. No mark allows it.
std::vector<std::string> typed_numbers_in(const std::vector<NamedText>& texts);

}  // namespace literate
