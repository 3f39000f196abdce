// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/text/latex.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace literate {
namespace {

/// LaTeX for a character that TeX interprets, or that some font encodings lack.
std::string_view command_of(char c) {
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
      return "\\char34{}";
    case '`':
      return "\\textasciigrave{}";
    default:
      return {};
  }
}

/// Two of these in a row are a ligature: --, '', ,, and so on.
constexpr std::string_view joined = "-',";
constexpr std::string_view escaped_by_backslash = "%#&_${}";

}  // namespace

std::string latex_escaped(std::string_view text) {
  std::string escaped;
  char previous = ' ';
  for (const char c : text) {
    if (c == previous && joined.find(c) != joined.npos) escaped += "{}";
    const std::string_view command = command_of(c);
    if (!command.empty()) {
      escaped += command;
    } else if (static_cast<unsigned char>(c) < 0x20) {
      escaped += ' ';
    } else {
      if (escaped_by_backslash.find(c) != escaped_by_backslash.npos) escaped += '\\';
      escaped += c;
    }
    previous = c;
  }
  return escaped;
}

std::string author_latex(std::string_view latex) {
  require_utf8(latex);
  std::string result;
  int depth = 0;
  bool is_escaped = false;  // by a backslash before it
  for (const char c : latex) {
    if (c == '%' && !is_escaped) result += '\\';
    if (!is_escaped && c == '{') ++depth;
    if (!is_escaped && c == '}' && --depth < 0) break;
    is_escaped = c == '\\' && !is_escaped;
    result += c == '\n' ? ' ' : c;
  }
  if (depth != 0)
    throw std::invalid_argument(fmt::format("the braces of '{}' do not match", latex));
  // A backslash at the end would escape the engine's next character.
  if (is_escaped) throw std::invalid_argument(fmt::format("'{}' ends with a backslash", latex));
  return result;
}

void require_utf8(std::string_view text) {
  try {
    (void)nlohmann::json(text).dump();  // results.json needs UTF-8
  } catch (const nlohmann::json::type_error&) {
    const auto is_ascii = [](char c) { return static_cast<unsigned char>(c) < 0x80; };
    const auto end = std::ranges::find_if_not(text, is_ascii);
    throw std::invalid_argument(
        fmt::format("the text '{}…' is not UTF-8", std::string_view(text.begin(), end)));
  }
}

}  // namespace literate
