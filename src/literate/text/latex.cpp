// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/text/latex.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

namespace literate {
namespace {

/// LaTeX for characters that TeX interprets, or that some font encodings lack.
constexpr auto commands = std::to_array<std::pair<char, std::string_view>>({
    {'\\', "\\textbackslash{}"},
    {'~', "\\textasciitilde{}"},
    {'^', "\\textasciicircum{}"},
    {'<', "\\textless{}"},
    {'>', "\\textgreater{}"},
    {'|', "\\textbar{}"},
    {'"', "\\char34{}"},
    {'`', "\\textasciigrave{}"},
});

/// Two of these in a row are a ligature: --, '', ,, and so on.
constexpr std::string_view joined = "-',";
constexpr std::string_view escaped_by_backslash = "%#&_${}";

}  // namespace

std::string latex_escaped(std::string_view text) {
  std::string escaped;
  char previous = ' ';
  for (const char c : text) {
    if (c == previous && joined.find(c) != joined.npos) escaped += "{}";
    const auto* const command =
        std::ranges::find(commands, c, &decltype(commands)::value_type::first);
    if (command != commands.end()) {
      escaped += command->second;
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
