// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/pattern.hpp"

#include <iterator>
#include <regex>

namespace sys {
namespace {

std::string_view view_of(const std::csub_match& part) {
  if (!part.matched) return {};
  return {part.first, static_cast<std::size_t>(part.length())};
}

Pattern::Match as_views(const std::cmatch& match) {
  Pattern::Match views;
  for (const std::csub_match& part : match) views.parts.push_back(view_of(part));
  views.before = view_of(match.prefix());
  views.rest = view_of(match.suffix());
  return views;
}

}  // namespace

struct Pattern::Compiled {
  std::regex regex;
};

Pattern::Pattern(std::string_view expression, bool ignores_case)
    : compiled_(new Compiled{std::regex(
          expression.begin(), expression.end(),
          ignores_case ? std::regex::ECMAScript | std::regex::icase : std::regex::ECMAScript)}) {}
Pattern::~Pattern() = default;
Pattern::Pattern(Pattern&&) noexcept = default;
Pattern& Pattern::operator=(Pattern&&) noexcept = default;

bool Pattern::is_in(std::string_view text) const {
  return find_in(text).has_value();
}

bool Pattern::is_all_of(std::string_view text) const {
  return match_all_of(text).has_value();
}

std::optional<Pattern::Match> Pattern::find_in(std::string_view text) const {
  std::cmatch match;
  const char* end = text.data() + text.size();
  if (!std::regex_search(text.data(), end, match, compiled_->regex)) return std::nullopt;
  return as_views(match);
}

std::optional<Pattern::Match> Pattern::find_at_begin_of(std::string_view text) const {
  std::cmatch match;
  const bool is_found = std::regex_search(text.data(), text.data() + text.size(), match,
                                          compiled_->regex, std::regex_constants::match_continuous);
  return is_found ? std::optional(as_views(match)) : std::nullopt;
}

std::vector<Pattern::Match> Pattern::all_in(std::string_view text) const {
  std::vector<Match> matches;
  std::cregex_iterator match(text.data(), text.data() + text.size(), compiled_->regex), end;
  for (; match != end; ++match) matches.push_back(as_views(*match));
  return matches;
}

std::vector<std::string_view> Pattern::split(std::string_view text) const {
  std::vector<std::string_view> between;
  for (const Match& match : all_in(text)) {
    between.push_back(match.before);
    text = match.rest;
  }
  between.push_back(text);
  return between;
}

std::string Pattern::replaced_in(std::string_view text, const std::string& replacement) const {
  std::string replaced;
  std::regex_replace(std::back_inserter(replaced), text.begin(), text.end(), compiled_->regex,
                     replacement);
  return replaced;
}

std::optional<Pattern::Match> Pattern::match_all_of(std::string_view text) const {
  std::cmatch match;
  const char* end = text.data() + text.size();
  if (!std::regex_match(text.data(), end, match, compiled_->regex)) return std::nullopt;
  return as_views(match);
}

}  // namespace sys
