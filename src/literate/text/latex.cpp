// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/text/latex.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <boost/algorithm/string/replace.hpp>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>

#include "literate/text/characters.hpp"
#include "system/utf8.hpp"

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

}  // namespace

std::string escape_latex(std::string_view text) {
  std::string escaped;
  while (!text.empty()) {
    const std::string_view character = sys::first_character(text).bytes;
    const std::string_view symbol = latex_of(character);
    if (character.size() == 1) {
      escaped += escape_ascii(character.front());
    } else {
      escaped += symbol.empty() ? character : symbol;
    }
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

}  // namespace

std::string plain_text(std::string_view latex) {
  std::string text;
  for (std::size_t i = 0; i < latex.size(); ++i) {
    const char c = latex[i];
    const std::string_view rest = latex.substr(i);
    if (c == '$' || c == '{' || c == '}') continue;
    if (rest.starts_with("---")) {
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
      const auto plain = plain_command(latex.substr(i, end - i));
      if (!plain) return std::string(latex);
      text += *plain;
      while (end < latex.size() && latex[end] == ' ') ++end;
      i = end - 1;
    }
  }
  return text;
}

void require_unit(std::string_view unit) {
  if (unit.find_first_of("%#&_$~\\{}") != std::string_view::npos) {
    throw std::invalid_argument(fmt::format("unit '{}' cannot be printed", unit));
  }
}

namespace {

using SignAndLatex = std::pair<std::string_view, std::string_view>;

/// The longer of two signs with the same beginning comes first, and the sign that is printed before
/// its twins.
constexpr SignAndLatex unit_signs[] = {
    {"°C", "\\degreeCelsius "},
    {"°", "\\degree "},
    {"µ", "\\micro "},  // micro sign
    {"μ", "\\micro "},  // mu
    {"Ω", "\\ohm "},    // Omega
    {"\u2126", "\\ohm "},
    {"Å", "\\LiterateAngstrom "},
    {"\u212B", "\\LiterateAngstrom "},
    {"′", "\\arcminute "},
    {"″", "\\arcsecond "},
};

/// What one word of a unit prints as: UDUNITS takes a «u» for micro, and names for signs.
std::string sign_of_unit(std::string_view word) {
  static const std::set<std::string_view> after_micro = {
      "m", "s", "g", "N",   "Pa",  "A",  "V", "W", "J",  "K",   "F",  "H",
      "C", "L", "l", "mol", "rad", "Hz", "T", "S", "Wb", "bar", "eV", "ohm"};
  static const std::map<std::string_view, std::string_view> names = {
      {"deg", "°"},   {"degree", "°"},   {"degrees", "°"}, {"degC", "°C"},
      {"degF", "°F"}, {"angstrom", "Å"}, {"micron", "µm"}};
  if (const auto name = names.find(word); name != names.end()) return std::string(name->second);
  if (word.starts_with('u') && after_micro.contains(word.substr(1))) {
    return "µ" + sign_of_unit(word.substr(1));
  }
  if (word == "ohm" || word == "kohm" || word == "Mohm" || word == "mohm") {
    return std::string(word.substr(0, word.size() - 3)) + "Ω";
  }
  return std::string(word);
}

}  // namespace

std::string plain_unit(std::string_view unit) {
  std::string text;
  while (!unit.empty()) {
    const auto end =
        static_cast<std::size_t>(std::ranges::find_if_not(unit, is_letter) - unit.begin());
    text += end == 0 ? std::string(unit.substr(0, 1)) : sign_of_unit(unit.substr(0, end));
    unit.remove_prefix(std::max<std::size_t>(end, 1));
  }
  return text;
}

std::string latex_unit(std::string_view unit) {
  std::string text = plain_unit(unit);
  for (const auto& [sign, latex] : unit_signs) boost::replace_all(text, sign, latex);
  return text;
}

std::string unit_of_latex(std::string_view latex) {
  std::string text(latex);
  for (const auto& [sign, command] : unit_signs) boost::replace_all(text, command, sign);
  return text;
}

}  // namespace literate
