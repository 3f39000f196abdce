// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace course {

/// The signs around a comment; `end` is empty where a comment ends with its line.
struct CommentSigns {
  std::string_view begin, end;
};

/// The signs of a kind of file: `//` for C++, `%` for TeX, `<!-- -->` for Markdown, HTML and XML,
/// and `#` for all others.
CommentSigns comment_signs(const std::string& file);

/// The words of a line that is a comment and nothing else, without the white space around them;
/// nothing for any other line.
std::optional<std::string_view> words_of_comment(std::string_view line, const CommentSigns& signs);

/// A line, and what ends it: "\n", "\r\n" or, at the end of the text, nothing.
struct LineWithEnd {
  std::string_view text, end;
};

/// The lines of a text, each with its end, so that both together are the text.
std::vector<LineWithEnd> lines_with_ends(std::string_view text);

/// A line that students must not see.
struct SecretLine {
  int line = 0;    ///< from 1, in the marked file
  int region = 0;  ///< line of its BEGIN marker
  std::string text;
};

/// The editions of a marked file.
struct MarkedText {
  std::string handout;   ///< for students: with stubs for solutions and without hidden tests
  std::string solution;  ///< for the instructor: everything but markers and stubs
  std::vector<SecretLine> secrets;  ///< the lines of solutions and hidden tests that are not blank
  std::vector<std::string> hidden_regions;  ///< the names given to hidden tests
};

/// Divides a text at its markers. These are comments on lines of their own, with `//`, `%`, `#` or
/// `<!-- -->` depending on the kind of file:
///
///     // BEGIN SOLUTION
///     // STUB: return 0;
///     return x + y;
///     // END SOLUTION
///
///     // BEGIN HIDDEN TESTS: name
///     // END HIDDEN TESTS
///
/// In the handout a solution becomes the comment YOUR SOLUTION HERE and its stub lines, with
/// the indentation and line end of its BEGIN line. Hidden tests need no name. Throws
/// sys::SourceError «file:line: …» for a region inside another, a marker without its partner, a
/// stub line anywhere but below BEGIN SOLUTION, and a line that looks like a marker but is none.
MarkedText apply_markers(std::string_view text, const std::string& file);

}  // namespace course
