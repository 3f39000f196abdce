// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace literate {

/// What TeX reads: a token of a document, with the place where it stands.
struct PageToken {
  enum class Kind : char {
    command,      ///< \name; `text` is the name, of letters or one other character
    character,    ///< one character of the text, in UTF-8
    space,        ///< blanks, or the end of a line
    paragraph,    ///< empty lines
    open,         ///< {
    close,        ///< }
    dollar,       ///< $ or $$
    align,        ///< &
    superscript,  ///< ^
    subscript,    ///< _
    parameter,    ///< #1; `text` is the digit
    verbatim,     ///< \verb or a verbatim environment, named in `text`; `body` has its characters
  };
  Kind kind = Kind::character;
  std::string text;
  std::string body = {};
  int file = -1;  ///< index of the file, negative for what the engine itself says
  int line = 0;   ///< from 1
  int column = 0;

  bool is(Kind asked) const { return kind == asked; }
  bool is_command(std::string_view name) const { return kind == Kind::command && text == name; }
  bool is_character(std::string_view character) const {
    return kind == Kind::character && text == character;
  }
};

using PageTokens = std::vector<PageToken>;

/// Splits a LaTeX text as TeX does: without comments, with blanks joined, and none after the name
/// of a command. `@` is a letter of names between \makeatletter and \makeatother, and everywhere if
/// `at_is_letter`, as in files that the engine writes.
PageTokens page_tokens(std::string_view latex, int file = -1, bool at_is_letter = true);

/// Whether there are only blanks.
bool is_blank(const PageTokens& tokens);

/// The tokens as LaTeX, as an author would write them.
std::string latex_of_tokens(const PageTokens& tokens);

}  // namespace literate
