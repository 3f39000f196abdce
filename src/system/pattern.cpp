// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/pattern.hpp"

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

std::optional<Pattern::Match> Pattern::match_all_of(std::string_view text) const {
  std::cmatch match;
  const char* end = text.data() + text.size();
  if (!std::regex_match(text.data(), end, match, compiled_->regex)) return std::nullopt;
  return as_views(match);
}

}  // namespace sys
