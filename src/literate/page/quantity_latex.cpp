// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <boost/algorithm/string/replace.hpp>
#include <map>

#include "literate/page/expansion.hpp"
#include "literate/text/latex.hpp"
#include "system/utf8.hpp"

namespace literate {
namespace {

std::string in_threes(std::string_view digits, bool from_left) {
  constexpr std::size_t fewest = 5;
  std::string text;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    const std::size_t from_point = from_left ? i : digits.size() - i;
    if (digits.size() >= fewest && i > 0 && from_point % 3 == 0) text += "\\,";
    text += digits[i];
  }
  return text;
}

/// A unit as plain_unit() writes it, with raised powers: «m s⁻¹», «m^(1/2)».
std::string unit_with_powers(std::string_view unit, bool is_math) {
  static const std::map<std::string_view, char> raised = {
      {"⁻", '-'}, {"⁰", '0'}, {"¹", '1'}, {"²", '2'}, {"³", '3'}, {"⁴", '4'},
      {"⁵", '5'}, {"⁶", '6'}, {"⁷", '7'}, {"⁸", '8'}, {"⁹", '9'}};
  std::string text, plain, power;
  const auto end_part = [&] {
    if (!plain.empty())
      text += is_math ? "\\text{" + escape_bookmark(plain) + "}" : escape_bookmark(plain);
    if (!power.empty()) {
      text += is_math ? "^{" + power + "}"
                      : "\\textsuperscript{" + boost::replace_all_copy(power, "-", "−") + "}";
    }
    plain.clear();
    power.clear();
  };
  while (!unit.empty()) {
    const std::string_view character = sys::first_character(unit).bytes;
    if (unit.starts_with("^(")) {
      const std::size_t end = unit.find(')');
      power = unit.substr(2, end - 2);
      unit.remove_prefix(end);
    } else if (const auto digit = raised.find(character); digit != raised.end()) {
      power += digit->second;
    } else {
      if (!power.empty()) end_part();
      plain += character;
    }
    unit.remove_prefix(unit.starts_with(')') && !power.empty() ? 1 : character.size());
  }
  end_part();
  return text;
}

constexpr std::string_view plus_minus = " ± ";

/// «0.786 ± 0.012», «994 +22 −18», «(4.7 ± 1.8)e-3 mm», «(994 ± 22 (statistics) ± 5 (calibration))
/// psi».
std::string with_plus_minus(std::string_view printed, bool is_math) {
  std::string_view rest;
  const bool has_brackets = printed.starts_with('(');
  if (has_brackets) {
    std::size_t end = 0;
    for (int depth = 0; end < printed.size(); ++end) {
      depth += (printed[end] == '(' ? 1 : 0) - (printed[end] == ')' ? 1 : 0);
      if (depth == 0) break;
    }
    rest = printed.substr(end + 1);
    printed = printed.substr(1, end - 1);
  }
  std::string text;
  if (const auto above = printed.find(" +"), below = printed.find(" −"); above != printed.npos) {
    text = quantity_latex(printed.substr(0, above), is_math);
    const std::string up = quantity_latex(printed.substr(above + 2, below - above - 2), is_math);
    const std::string down =
        quantity_latex(printed.substr(below + std::string_view(" −").size()), is_math);
    text += is_math ? fmt::format("^{{+{}}}_{{-{}}}", up, down) : fmt::format("~+{}~−{}", up, down);
    printed = {};
  }
  for (std::string_view part = printed; !part.empty();) {
    const auto next = std::min(part.find(plus_minus), part.size());
    const std::string_view of = part.substr(0, next);
    const auto word = std::min(of.find(" ("), of.size());
    if (!text.empty()) text += is_math ? "\\pm " : "~±~";
    text += quantity_latex(of.substr(0, word), is_math);
    const std::string what = escape_bookmark(of.substr(word));
    text += is_math && !what.empty() ? "\\text{" + what + "}" : what;
    part.remove_prefix(std::min(next + plus_minus.size(), part.size()));
  }
  if (!has_brackets) return text;
  text = "(" + text + ")";
  if (rest.starts_with('e')) {
    return text + (is_math ? "\\times " : "~×~") + quantity_latex(rest, is_math);
  }
  if (rest.empty()) return text;
  return text + (is_math ? "\\," : "~") + unit_with_powers(rest.substr(1), is_math);
}

}  // namespace

std::string quantity_latex(std::string_view printed, bool is_math) {
  if (printed.find(plus_minus) != printed.npos || printed.find(" +") != printed.npos)
    return with_plus_minus(printed, is_math);
  const auto blank = printed.find(' ');
  std::string_view number = printed.substr(0, blank);
  const bool is_number = number.find_first_not_of("+-.0123456789()e") == number.npos &&
                         !number.empty() && number.find_first_of("0123456789") != number.npos;
  if (!is_number) return escape_latex(printed);
  const auto e = number.find('e');
  std::string exponent(e == number.npos ? "" : number.substr(e + 1));
  if (exponent == "0") exponent.clear();  // as siunitx prints it
  std::string_view mantissa = number.substr(0, e);
  std::string text;
  if (mantissa.starts_with('-')) text = is_math ? "{-}" : "−";
  mantissa.remove_prefix(mantissa.starts_with('-') ? 1 : 0);
  const auto bracket = std::min(mantissa.find('('), mantissa.size());
  const auto point = std::min(mantissa.find('.'), bracket);
  text += in_threes(mantissa.substr(0, point), false);
  if (point < bracket)
    text += "." + in_threes(mantissa.substr(point + 1, bracket - point - 1), true);
  text += mantissa.substr(bracket);
  if (!exponent.empty() && is_math) {
    text += (text.empty() ? "" : "\\times") + ("10^{" + exponent + "}");
  }
  if (!exponent.empty() && !is_math) {
    text += fmt::format("{}10\\textsuperscript{{{}}}", text.empty() ? "" : "~×~",
                        boost::replace_all_copy(exponent, "-", "−"));
  }
  if (blank == printed.npos) return text;
  return text + (is_math ? "\\," : "~") + unit_with_powers(printed.substr(blank + 1), is_math);
}

}  // namespace literate
