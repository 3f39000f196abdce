// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/page/tex_reader.hpp"

#include <cstdlib>
#include <ranges>
#include <utility>

namespace literate {
namespace {

using Kind = PageToken::Kind;

PageTokens parameters(int n) {
  PageTokens pattern;
  for (int i = 1; i <= n; ++i)
    pattern.push_back({.kind = Kind::parameter, .text = std::to_string(i)});
  return pattern;
}

bool is_same(const PageToken& a, const PageToken& b) {
  return a.kind == b.kind && a.text == b.text;
}

}  // namespace

std::optional<PageToken> TexReader::next() {
  if (pending_.empty()) return std::nullopt;
  PageToken token = std::move(pending_.back());
  pending_.pop_back();
  return token;
}

void TexReader::push(const PageTokens& tokens) {
  pending_.insert(pending_.end(), tokens.rbegin(), tokens.rend());
}

void TexReader::skip_spaces() {
  while (!pending_.empty() && pending_.back().is(Kind::space)) pending_.pop_back();
}

bool TexReader::star() {
  if (pending_.empty() || !pending_.back().is_character("*")) return false;
  pending_.pop_back();
  return true;
}

PageTokens TexReader::argument() {
  while (!pending_.empty() &&
         (pending_.back().is(Kind::space) || pending_.back().is(Kind::paragraph))) {
    pending_.pop_back();
  }
  std::optional<PageToken> first = next();
  if (!first) return {};
  if (!first->is(Kind::open)) return {*std::move(first)};
  PageTokens tokens;
  int depth = 1;
  while (std::optional<PageToken> token = next()) {
    if (token->is(Kind::open)) ++depth;
    if (token->is(Kind::close) && --depth == 0) break;
    tokens.push_back(*std::move(token));
  }
  return tokens;
}

std::optional<PageTokens> TexReader::optional_argument() {
  std::size_t n_blanks = 0;
  while (n_blanks < pending_.size() && pending_[pending_.size() - 1 - n_blanks].is(Kind::space)) {
    ++n_blanks;
  }
  if (n_blanks == pending_.size() || !pending_[pending_.size() - 1 - n_blanks].is_character("[")) {
    return std::nullopt;
  }
  pending_.resize(pending_.size() - n_blanks - 1);
  PageTokens tokens;
  int depth = 0;
  while (std::optional<PageToken> token = next()) {
    if (token->is(Kind::open)) ++depth;
    if (token->is(Kind::close)) --depth;
    if (depth == 0 && token->is_character("]")) break;
    tokens.push_back(*std::move(token));
  }
  if (tokens.size() >= 2 && tokens.front().is(Kind::open) && tokens.back().is(Kind::close)) {
    tokens.erase(tokens.begin());
    tokens.pop_back();
  }
  return tokens;
}

PageTokens TexReader::environment_body(std::string_view name) {
  PageTokens body;
  int depth = 0;
  while (std::optional<PageToken> token = next()) {
    if (token->is_command("begin") || token->is_command("end")) {
      const bool begins = token->text == "begin";
      const PageTokens argument_tokens = argument();
      if (latex_of_tokens(argument_tokens) == name) {
        if (!begins && depth == 0) return body;
        depth += begins ? 1 : -1;
      }
      PageToken open = *token;
      body.push_back(*std::move(token));
      open.kind = Kind::open;
      open.text = "{";
      body.push_back(open);
      body.insert(body.end(), argument_tokens.begin(), argument_tokens.end());
      open.kind = Kind::close;
      open.text = "}";
      body.push_back(open);
      continue;
    }
    body.push_back(*std::move(token));
  }
  return body;
}

std::string TexReader::text_argument() {
  return text_of(argument());
}

std::string TexReader::text_of(const PageTokens& tokens) {
  std::vector<PageToken> rest = set_aside();
  push(tokens);
  std::string text;
  while (std::optional<PageToken> token = next()) {
    if (token->is(Kind::command)) {
      if (expand(token->text)) continue;
      text += '\\' + token->text;
    } else if (token->is(Kind::parameter)) {
      text += '#' + token->text;
    } else if (token->text == "\u00A0") {
      text += '~';
    } else {
      text += token->text;
    }
  }
  take_back(std::move(rest));
  const std::size_t begin = text.find_first_not_of(' ');
  if (begin == std::string::npos) return {};
  return text.substr(begin, text.find_last_not_of(' ') + 1 - begin);
}

void TexReader::end_group() {
  if (saved_.empty()) return;
  for (auto& [name, macro] : saved_.back()) {
    if (macro) {
      macros_[name] = *std::move(macro);
    } else {
      macros_.erase(name);
    }
  }
  saved_.pop_back();
}

const PageMacro* TexReader::find(const std::string& name) const {
  const auto found = macros_.find(name);
  return found == macros_.end() ? nullptr : &found->second;
}

void TexReader::define(const std::string& name, PageMacro macro) {
  if (!saved_.empty() && !saved_.back().contains(name)) {
    const PageMacro* const former = find(name);
    saved_.back()[name] = former ? std::optional(*former) : std::nullopt;
  }
  macros_[name] = std::move(macro);
}

bool TexReader::read_definition(const std::string& command) {
  if (command == "newcommand" || command == "renewcommand" || command == "providecommand" ||
      command == "DeclareRobustCommand") {
    read_newcommand(command == "providecommand");
  } else if (command == "def" || command == "gdef" || command == "edef" || command == "xdef") {
    read_def();
  } else if (command == "let") {
    read_let();
  } else {
    return false;
  }
  return true;
}

void TexReader::read_newcommand(bool only_if_new) {
  star();
  const PageTokens name = argument();
  PageMacro macro;
  if (const auto n = optional_argument()) {
    macro.pattern = parameters(std::atoi(latex_of_tokens(*n).c_str()));
    macro.default_value = optional_argument();
  }
  macro.body = argument();
  if (name.size() != 1 || (only_if_new && knows(name.front().text))) return;
  define(name.front().text, std::move(macro));
}

void TexReader::read_def() {
  const std::optional<PageToken> name = next();
  PageMacro macro;
  while (peek() != nullptr && !peek()->is(Kind::open)) macro.pattern.push_back(*next());
  macro.body = argument();
  if (name) define(name->text, std::move(macro));
}

void TexReader::read_let() {
  const std::optional<PageToken> name = next();
  skip_spaces();
  if (peek() != nullptr && peek()->is_character("=")) next();
  const std::optional<PageToken> other = next();
  if (!name || !other) return;
  const PageMacro* const known = other->is(Kind::command) ? find(other->text) : nullptr;
  define(name->text, known ? *known : PageMacro{.pattern = {}, .body = {*other}});
}

PageTokens TexReader::until(const PageTokens& delimiter) {
  PageTokens tokens;
  int depth = 0;
  while (std::optional<PageToken> token = next()) {
    if (depth == 0 && is_same(*token, delimiter.front())) break;
    if (token->is(Kind::open)) ++depth;
    if (token->is(Kind::close)) --depth;
    tokens.push_back(*std::move(token));
  }
  for (std::size_t i = 1; i < delimiter.size(); ++i) next();
  return tokens;
}

bool TexReader::expand(const std::string& name) {
  const PageMacro* const found = find(name);
  if (found == nullptr) return false;
  const PageMacro macro = *found;
  std::map<std::string, PageTokens> arguments;
  std::size_t i = 0;
  if (macro.default_value && !macro.pattern.empty()) {
    arguments[macro.pattern[i++].text] = optional_argument().value_or(*macro.default_value);
  }
  while (i < macro.pattern.size()) {
    const PageToken& parameter = macro.pattern[i++];
    if (!parameter.is(Kind::parameter)) {  // a delimiter in front of all parameters
      next();
      continue;
    }
    PageTokens delimiter;
    while (i < macro.pattern.size() && !macro.pattern[i].is(Kind::parameter)) {
      delimiter.push_back(macro.pattern[i++]);
    }
    arguments[parameter.text] = delimiter.empty() ? argument() : until(delimiter);
  }
  PageTokens body;
  for (const PageToken& token : macro.body) {
    if (token.is(Kind::parameter)) {
      const PageTokens& inserted = arguments[token.text];
      body.insert(body.end(), inserted.begin(), inserted.end());
    } else {
      body.push_back(token);
    }
  }
  push(body);
  return true;
}

}  // namespace literate
