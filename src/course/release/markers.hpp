// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace course {

/// A line that students must not see.
struct SecretLine {
  int line = 0;    ///< from 1, in the marked file
  int region = 0;  ///< line of its BEGIN marker
  std::string text;
};

/// What a marked file says to whom.
struct MarkedText {
  std::string handout;                      ///< to students: stubs for solutions, no hidden tests
  std::string solution;                     ///< to the instructor: everything but markers and stubs
  std::vector<SecretLine> secrets;          ///< of solutions and hidden tests, none blank
  std::vector<std::string> hidden_regions;  ///< the names given to hidden tests
};

/// Divides a text at its markers, which are comments of the file's kind, `//`, `%`, `#` or
/// `<!-- -->`, on lines of their own:
///
///     // BEGIN SOLUTION
///     // STUB: return 0;
///     return x + y;
///     // END SOLUTION
///
///     // BEGIN HIDDEN TESTS: name
///     // END HIDDEN TESTS
///
/// In the handout a solution is the comment YOUR SOLUTION HERE and its stub lines, with the
/// indentation and line end of its BEGIN line; the name of hidden tests may be left out. Throws
/// sys::SourceError «file:line: …» for a region in another, a marker without its partner, a
/// stub line anywhere but below BEGIN SOLUTION, and words that were meant as a marker and are none.
MarkedText apply_markers(std::string_view text, const std::string& file);

}  // namespace course
