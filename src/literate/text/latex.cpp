// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/text/latex.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <string>

#include "literate/text/characters.hpp"
#include "literate/text/unit.hpp"
#include "system/text.hpp"

namespace literate {
namespace {

std::string escape_ascii(char c) {
  switch (c) {
    case '\\':
      return "\\textbackslash{}";
    case '~':
      return "\\textasciitilde{}";
    case '^':
      return "\\textasciicircum{}";
    case '<':
      return "\\textless{}";
    case '>':
      return "\\textgreater{}";
    case '|':
      return "\\textbar{}";
    case '"':
      return "\\textquotedbl{}";
    case '%':
    case '#':
    case '&':
    case '_':
    case '$':
    case '{':
    case '}':
      return std::string("\\") + c;
    default:
      return std::string(1, static_cast<unsigned char>(c) < 0x20 ? ' ' : c);
  }
}

constexpr std::string_view raised_group = "\\ensuremath{^{", lowered_group = "\\ensuremath{_{";

bool is_shifted_alike(std::string_view a, std::string_view b) {
  return (a.starts_with(raised_group) && b.starts_with(raised_group)) ||
         (a.starts_with(lowered_group) && b.starts_with(lowered_group));
}

}  // namespace

std::string escape_latex(std::string_view text) {
  std::string escaped;
  std::string_view former;
  while (!text.empty()) {
    const std::string_view character = sys::first_character(text).bytes;
    const std::string_view symbol = latex_of(character);
    if (character.size() == 1) {
      escaped += escape_ascii(character.front());
    } else if (is_shifted_alike(former, symbol)) {
      // An exponent of several characters, such as ⁻⁹, is one.
      escaped.resize(escaped.size() - 2);
      escaped += symbol.substr(raised_group.size());
    } else {
      escaped += symbol.empty() ? character : symbol;
    }
    former = symbol;
    text.remove_prefix(character.size());
  }
  return escaped;
}

std::string_view first_unprintable(std::string_view text) {
  constexpr unsigned char first_printable = 0x20;
  constexpr unsigned char del = 0x7f;
  while (!text.empty()) {
    const std::string_view character = sys::first_character(text).bytes;
    const auto byte = static_cast<unsigned char>(character.front());
    const bool is_printable = byte < del ? byte >= first_printable : !latex_of(character).empty();
    if (!is_printable) return character;
    text.remove_prefix(character.size());
  }
  return {};
}

std::string escape_bookmark(std::string_view text) {
  std::string escaped;
  for (const char c : text) escaped += escape_ascii(c);
  return escaped;
}

std::string escape_latex_path(std::string_view path) {
  std::string escaped;
  for (const char c : path) escaped += c == '/' ? "/\\allowbreak{}" : escape_latex({&c, 1});
  return escaped;
}

namespace {

/// What a command prints as plain text; none if that is not known.
std::optional<std::string_view> plain_command(std::string_view name) {
  static const std::map<std::string_view, std::string_view> others = {
      {"ensuremath", ""}, {"mathrm", ""},         {"mathit", ""}, {"mathbf", ""}, {"text", ""},
      {"textbf", ""},     {"textit", ""},         {"textrm", ""}, {"texttt", ""}, {"emph", ""},
      {"left", ""},       {"right", ""},          {"quad", " "},  {"qquad", " "}, {"ldots", "…"},
      {"dots", "…"},      {"textbackslash", "\\"}};
  if (const auto known = others.find(name); known != others.end()) return known->second;
  const std::string_view character = character_of("\\" + std::string(name));
  if (character.empty()) return std::nullopt;
  return character;
}

/// What the braces at `at` hold, which is then behind them; empty where there are none.
std::string_view group_at(std::string_view latex, std::size_t& at) {
  if (at >= latex.size() || latex[at] != '{') return {};
  int depth = 0;
  for (std::size_t i = at; i < latex.size(); ++i) {
    depth += latex[i] == '{' ? 1 : latex[i] == '}' ? -1 : 0;
    if (depth > 0) continue;
    const std::string_view group = latex.substr(at + 1, i - at - 1);
    at = i + 1;
    return group;
  }
  return {};
}

/// What siunitx prints for a command whose arguments begin at `at`; none for other commands.
std::optional<std::string> plain_quantity(std::string_view name, std::string_view latex,
                                          std::size_t& at) {
  const bool has_number = name == "num" || name == "qty" || name == "SI";
  const bool has_unit = name == "unit" || name == "si" || name == "qty" || name == "SI";
  if (!has_number && !has_unit) return std::nullopt;
  std::string text;
  if (has_number) text += group_at(latex, at);
  if (has_number && has_unit) text += ' ';
  if (has_unit) text += unit_of_latex(group_at(latex, at));
  return text;
}

}  // namespace

std::string plain_text(std::string_view latex) {
  constexpr std::string_view degree = "^\\circ", braced_degree = "^{\\circ}";
  std::string text;
  for (std::size_t i = 0; i < latex.size(); ++i) {
    const char c = latex[i];
    const std::string_view rest = latex.substr(i);
    if (c == '$' || c == '{' || c == '}') continue;
    if (rest.starts_with(braced_degree) || rest.starts_with(degree)) {
      text += "°";
      i += (rest[1] == '{' ? braced_degree : degree).size() - 1;
    } else if (rest.starts_with("---")) {
      text += "—";
      i += 2;
    } else if (rest.starts_with("--")) {
      text += "–";
      ++i;
    } else if (c == '~' || c == '\n') {
      text += ' ';
    } else if (c != '\\' || i + 1 == latex.size()) {
      text += c;
    } else if (const char next = latex[++i]; !is_letter(next)) {
      constexpr std::string_view spaces = ",;: \\";
      if (next != '!' && next != '/') text += spaces.find(next) != spaces.npos ? ' ' : next;
    } else {
      std::size_t end = i;
      while (end < latex.size() && is_letter(latex[end])) ++end;
      const std::string_view name = latex.substr(i, end - i);
      if (const auto quantity = plain_quantity(name, latex, end)) {
        if (quantity->find('\\') != quantity->npos) return std::string(latex);
        text += *quantity;
        i = end - 1;
        continue;
      }
      const auto plain = plain_command(name);
      if (!plain) return std::string(latex);
      text += *plain;
      while (end < latex.size() && latex[end] == ' ') ++end;
      i = end - 1;
    }
  }
  return text;
}

}  // namespace literate
