// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/prose/tex_scanner.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <set>

#include "literate/text/characters.hpp"
#include "system/text.hpp"

namespace literate {
namespace {

constexpr auto npos = std::string_view::npos;

const std::set<std::string_view> verbatim_environments = {"verbatim", "verbatim*", "lstlisting",
                                                          "comment"};
const std::set<std::string_view> displays = {
    "equation", "equation*", "align",     "align*",   "alignat",     "alignat*", "gather",
    "gather*",  "multline",  "multline*", "eqnarray", "displaymath", "eqnarray*"};

std::string_view inside(std::string_view group) {
  const auto open = group.find('{');
  return group.substr(open + 1, group.size() - open - 2);
}

/// The length of a \verb whose delimiter, or star, stands at `at`; it ends on its line.
std::size_t verb_length(std::string_view text, std::size_t at) {
  if (at < text.size() && text[at] == '*') ++at;
  const auto line = text.substr(0, text.find('\n', at));
  const auto end = at < line.size() ? line.find(line[at], at + 1) : npos;
  return end == npos ? line.size() : end + 1;
}

}  // namespace

std::optional<TexToken> TexScanner::next() {
  if (rest_.empty()) return std::nullopt;
  switch (rest_.front()) {
    case '%':
      return take(TexKind::comment, rest_.find('\n'));
    case '{':
      return take(TexKind::open, 1);
    case '}':
      return take(TexKind::close, 1);
    case '$':
      return take_dollar();
    case '\\':
      return take_command();
    default:
      return take(TexKind::text, rest_.find_first_of("%{}$\\"));
  }
}

std::string_view TexScanner::skip(std::size_t n_bytes) {
  const std::string_view skipped = rest_.substr(0, n_bytes);
  rest_.remove_prefix(skipped.size());
  return skipped;
}

void TexScanner::skip_blanks() {
  while (true) {
    skip(rest_.find_first_not_of(" \t\r\n"));
    if (!rest_.starts_with('%')) return;
    next();
  }
}

TexToken TexScanner::take(TexKind kind, std::size_t n_bytes, std::string_view name) {
  return {kind, skip(n_bytes), name, mode_};
}

TexToken TexScanner::take_dollar() {
  const bool is_display = mode_ != TexMode::inline_math && rest_.starts_with("$$");
  const TexToken token = take(TexKind::dollar, is_display ? 2 : 1);
  const TexMode inside = is_display ? TexMode::display_math : TexMode::inline_math;
  mode_ = mode_ == TexMode::text ? inside : TexMode::text;
  return token;
}

TexToken TexScanner::take_symbol() {
  const TexToken token = take(TexKind::symbol, 2);
  if (token.text == "\\[") mode_ = TexMode::display_math;
  if (token.text == "\\(") mode_ = TexMode::inline_math;
  if (token.text == "\\]" || token.text == "\\)") mode_ = TexMode::text;
  return token;
}

TexToken TexScanner::take_command() {
  const auto letters_end = std::find_if_not(rest_.begin() + 1, rest_.end(), is_command_letter);
  auto end = static_cast<std::size_t>(letters_end - rest_.begin());
  const std::string_view name = rest_.substr(1, end - 1);
  if (name.empty()) return take_symbol();
  if (name == "verb") return take(TexKind::verbatim, verb_length(rest_, end));
  if (name == "url" || name == "nolinkurl" || name == "href") {
    const std::string_view address = group_at(rest_.substr(end));
    if (!address.empty()) return take(TexKind::verbatim, end + address.size(), name);
  }
  if (name == "begin" || name == "end") {
    const std::string_view group = group_at(rest_.substr(end));
    if (!group.empty()) return take_environment(name == "begin", end + group.size(), inside(group));
  }
  if (end < rest_.size() && rest_[end] == '*') ++end;
  return take(TexKind::command, end, name);
}

TexToken TexScanner::take_environment(bool begins, std::size_t n_bytes, std::string_view name) {
  if (begins && verbatim_environments.contains(name)) {
    const std::string end = fmt::format("\\end{{{}}}", name);
    const auto at = rest_.find(end);
    return take(TexKind::verbatim, at == npos ? npos : at + end.size(), name);
  }
  if (displays.contains(name)) mode_ = begins ? TexMode::display_math : TexMode::text;
  return take(begins ? TexKind::begin : TexKind::end, n_bytes, name);
}

std::string without_comments(std::string_view latex) {
  std::string text;
  TexScanner scanner(latex);
  while (const auto token = scanner.next()) {
    if (token->kind != TexKind::comment) text += token->text;
  }
  return sys::one_line(text);
}

std::string_view group_at(std::string_view text, char open, char close) {
  std::size_t at = text.find_first_not_of(" \t");
  if (at == npos || text[at] != open) return {};
  int depth = 0;
  for (; at < text.size(); ++at) {
    if (text[at] == '\\') {
      ++at;  // an escaped delimiter is none
    } else if (text[at] == open) {
      ++depth;
    } else if (text[at] == close && --depth == 0) {
      return text.substr(0, at + 1);
    }
  }
  return {};
}

std::string_view argument_at(std::string_view text) {
  const std::string_view group = group_at(text.substr(0, text.find('\n')));
  return group.empty() ? group : sys::stripped(inside(group));
}

TexPlace place_in(std::string_view text, std::string_view part) {
  const std::string_view before =
      text.substr(0, static_cast<std::size_t>(part.data() - text.data()));
  const std::string_view line = before.substr(before.rfind('\n') + 1);
  return {1 + static_cast<int>(std::ranges::count(before, '\n')),
          1 + static_cast<int>(sys::n_characters(line))};
}

}  // namespace literate
