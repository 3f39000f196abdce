// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string_view>
#include <vector>

namespace sys {

/// A regular expression as std::regex reads it (ECMAScript). Here so that std::regex, which takes
/// seconds to compile in each file, is compiled once.
class Pattern {
 public:
  /// Throws std::regex_error for an expression that is none.
  explicit Pattern(std::string_view expression, bool ignores_case = false);
  ~Pattern();
  Pattern(Pattern&&) noexcept;
  Pattern& operator=(Pattern&&) noexcept;

  /// What was found, as views of the text that was searched.
  struct Match {
    std::vector<std::string_view> parts;  ///< the whole and each group, empty for one left out
    std::string_view rest;                ///< what follows
  };

  bool is_in(std::string_view text) const;
  bool is_all_of(std::string_view text) const;

  /// The first place where it stands.
  std::optional<Match> find_in(std::string_view text) const;

  /// The groups, if it is all of the text.
  std::optional<Match> match_all_of(std::string_view text) const;

 private:
  struct Compiled;
  std::unique_ptr<const Compiled> compiled_;
};

}  // namespace sys
