// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
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
        parts;              ///< the whole match and each group; an unmatched group is empty
    std::string_view rest;  ///< the text after the match
  };

  /// Whether a part of the text matches.
  bool is_in(std::string_view text) const;

  /// Whether the whole text matches.
  bool is_all_of(std::string_view text) const;

  /// The first match in the text.
  std::optional<Match> find_in(std::string_view text) const;

  /// The match, if the whole text matches.
  std::optional<Match> match_all_of(std::string_view text) const;

 private:
  struct Compiled;
  std::unique_ptr<const Compiled> compiled_;
};

}  // namespace sys
