// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sys {

/// A regular expression in the ECMAScript syntax of std::regex. This class hides std::regex, which
/// takes seconds to compile, from the files that use it.
class Pattern {
 public:
  /// Throws std::regex_error for an expression that is not valid.
  explicit Pattern(std::string_view expression, bool ignores_case = false);
  ~Pattern();
  Pattern(Pattern&&) noexcept;
  Pattern& operator=(Pattern&&) noexcept;

  /// A match, as views of the text that was searched.
  struct Match {
    std::vector<std::string_view>
        parts;                ///< the whole match and each group; an unmatched group is empty
    std::string_view before;  ///< the text between the match before, or the begin, and this one
    std::string_view rest;    ///< the text after the match

    /// The whole match, or a group.
    std::string str(std::size_t i = 0) const { return std::string(parts.at(i)); }
  };

  /// Whether a part of the text matches.
  bool is_in(std::string_view text) const;

  /// Whether the whole text matches.
  bool is_all_of(std::string_view text) const;

  /// The first match in the text.
  std::optional<Match> find_in(std::string_view text) const;

  /// The match with which the text begins, if it begins with one.
  std::optional<Match> find_at_begin_of(std::string_view text) const;

  /// All matches, from left to right.
  std::vector<Match> all_in(std::string_view text) const;

  /// What stands between the matches.
  std::vector<std::string_view> split(std::string_view text) const;

  /// The text with each match replaced, where $1 is the first group of the match.
  std::string replaced_in(std::string_view text, const std::string& replacement) const;

  /// The match, if the whole text matches.
  std::optional<Match> match_all_of(std::string_view text) const;

 private:
  struct Compiled;
  std::unique_ptr<const Compiled> compiled_;
};

}  // namespace sys
