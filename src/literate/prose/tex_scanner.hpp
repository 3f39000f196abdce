// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace literate {

/// How a character of a LaTeX text is read.
enum class TexMode : char { text, inline_math, display_math };

enum class TexKind {
  text,      ///< characters without a meaning of their own
  comment,   ///< from % to the end of the line, which does not belong to it
  verbatim,  ///< \verb with its text, \url or \href with its address, in which % begins no comment;
             ///< a whole verbatim or lstlisting environment
  command,   ///< \name, with a star if there is one
  symbol,    ///< a backslash and a character that is no letter
  begin,     ///< \begin{name}
  end,       ///< \end{name}
  dollar,    ///< $ or $$
  open,      ///< {
  close      ///< }
};

struct TexToken {
  TexKind kind;
  std::string_view text;
  std::string_view name;  ///< of a command or an environment; empty for the rest
  TexMode mode;           ///< in which the token is read
};

/// Splits a LaTeX text into tokens, which together are the text. It does not expand macros; the
/// name of a command may hold '@'.
class TexScanner {
 public:
  explicit TexScanner(std::string_view latex) : rest_(latex) {}

  /// The next token; none at the end of the text.
  std::optional<TexToken> next();

  /// The text that was not read yet.
  std::string_view rest() const { return rest_; }

  /// Skips the next `n_bytes`, or all of a shorter rest, and returns what was skipped.
  std::string_view skip(std::size_t n_bytes);

  /// Goes past blanks, line ends and comments.
  void skip_blanks();

 private:
  TexToken take(TexKind kind, std::size_t n_bytes, std::string_view name = {});
  TexToken take_dollar();
  TexToken take_symbol();
  TexToken take_command();
  TexToken take_environment(bool begins, std::size_t n_bytes, std::string_view name);

  std::string_view rest_;
  TexMode mode_ = TexMode::text;
};

/// LaTeX in one line, without its comments, which end with their line.
std::string without_comments(std::string_view latex);

/// The group at the start of a text, with its delimiters and the blanks before them; empty if the
/// text starts with something else or the group is not closed.
std::string_view group_at(std::string_view text, char open = '{', char close = '}');

/// The content of the group in braces at the start of a text, without blanks at its ends; empty if
/// there is no such group within the first line.
std::string_view argument_at(std::string_view text);

/// A place in a text. Lines and columns count from 1, columns in characters.
struct TexPlace {
  int line;
  int column;
};

/// The place at which a part of a text begins; the part must be a view of the text.
TexPlace place_in(std::string_view text, std::string_view part);

}  // namespace literate
