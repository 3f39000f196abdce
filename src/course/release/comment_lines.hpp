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

}  // namespace course
