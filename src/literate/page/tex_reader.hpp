// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "literate/page/tex_tokens.hpp"

namespace literate {

/// A command that the document defines.
struct PageMacro {
  PageTokens pattern;                            ///< of \def: parameters, and what delimits them
  std::optional<PageTokens> default_value = {};  ///< of the first argument, which is then optional
  PageTokens body = {};
};

/// Reads tokens, and what the document's own commands expand to.
///
/// It knows \newcommand and its kin, \def and \let; what else a command does is its caller's
/// business. Definitions end with their group.
class TexReader {
 public:
  /// The next token; none where what was pushed ends.
  std::optional<PageToken> next();
  const PageToken* peek() const { return pending_.empty() ? nullptr : &pending_.back(); }
  bool at_end() const { return pending_.empty(); }

  /// These tokens are read next.
  void push(const PageTokens& tokens);
  void push(PageToken token) { pending_.push_back(std::move(token)); }

  /// Sets aside what is still to be read, and takes it back.
  std::vector<PageToken> set_aside() { return std::exchange(pending_, {}); }
  void take_back(std::vector<PageToken> pending) { pending_ = std::move(pending); }

  void skip_spaces();
  /// Whether the next token is a star, which is then read.
  bool star();
  /// The next argument: a group without its braces, or one token. Blanks before it are skipped.
  PageTokens argument();
  /// An argument in brackets, if there is one.
  std::optional<PageTokens> optional_argument();
  /// The tokens up to the matching \end{name}, which is read.
  PageTokens environment_body(std::string_view name);
  /// An argument as characters, with the document's own commands expanded.
  std::string text_argument();
  std::string text_of(const PageTokens& tokens);

  void begin_group() { saved_.emplace_back(); }
  void end_group();

  bool knows(const std::string& name) const { return macros_.contains(name); }
  const PageMacro* find(const std::string& name) const;
  void define(const std::string& name, PageMacro macro);
  /// Reads what follows \newcommand, \renewcommand, \providecommand, \def or \let, and defines it;
  /// false if `command` is none of these.
  bool read_definition(const std::string& command);
  /// Replaces a command of the document by what it expands to; false if it is none.
  bool expand(const std::string& name);

 private:
  void read_newcommand(bool only_if_new);
  void read_def();
  void read_let();
  PageTokens until(const PageTokens& delimiter);

  std::vector<PageToken> pending_;  // the next one last
  std::map<std::string, PageMacro> macros_;
  std::vector<std::map<std::string, std::optional<PageMacro>>> saved_;
};

}  // namespace literate
