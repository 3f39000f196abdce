// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/page/html_text.hpp"

#include <boost/algorithm/string/replace.hpp>
#include <map>
#include <regex>
#include <utility>

#include "system/text.hpp"

namespace literate {

std::string escape_html(std::string_view text) {
  std::string escaped(text);
  for (const auto& [character, entity] :
       {std::pair{"&", "&amp;"}, {"<", "&lt;"}, {">", "&gt;"}, {"\"", "&quot;"}}) {
    boost::replace_all(escaped, character, entity);
  }
  return escaped;
}

namespace {

// Digits and signs as raised or lowered characters; empty if there is none for one of them.
std::string shifted(const std::string& text, bool is_raised) {
  static const std::map<std::string, std::pair<const char*, const char*>> forms{
      {"0", {"⁰", "₀"}}, {"1", {"¹", "₁"}}, {"2", {"²", "₂"}}, {"3", {"³", "₃"}},
      {"4", {"⁴", "₄"}}, {"5", {"⁵", "₅"}}, {"6", {"⁶", "₆"}}, {"7", {"⁷", "₇"}},
      {"8", {"⁸", "₈"}}, {"9", {"⁹", "₉"}}, {"−", {"⁻", "₋"}}, {"+", {"⁺", "₊"}}};
  std::string made;
  for (std::size_t at = 0; at < text.size();) {
    const std::string sign = text.substr(at, text.compare(at, 3, "−") == 0 ? 3 : 1);
    const auto form = forms.find(sign);
    if (form == forms.end()) return {};
    made += is_raised ? form->second.first : form->second.second;
    at += sign.size();
  }
  return made;
}

// Exponents, indices and fractions of numbers, which without their tags would be digits in a row.
std::string with_plain_numbers(std::string html) {
  static const std::regex fraction("<mfrac><m[in]>([^<]*)</m[in]><m[in]>([^<]*)</m[in]></mfrac>");
  static const std::regex shift(
      "<(su[pb])>([^<]*)</su[pb]>|"
      "(?:<mrow><mo[^>]*>(−)</mo><mn>([0-9]+)</mn></mrow>|<mn>([0-9]+)</mn>)"
      "</m(su[pb])>");
  html = std::regex_replace(html, fraction, "$1/$2");
  std::string text;
  std::smatch found;
  while (std::regex_search(html, found, shift)) {
    const bool is_raised = found[1].str() == "sup" || found[6].str() == "sup";
    const std::string inside = found[2].str() + found[3].str() + found[4].str() + found[5].str();
    const std::string made = shifted(inside, is_raised);
    text += found.prefix().str() + (made.empty() ? inside : made);
    html = found.suffix().str();
  }
  return text + html;
}

}  // namespace

std::string text_of_html(std::string_view html) {
  static const std::regex tag("<[^>]*>");
  const std::string plain = std::regex_replace(with_plain_numbers(std::string(html)), tag, "");
  return sys::one_line(plain);
}

std::string one_word(const std::string& verdict) {
  return verdict.substr(0, verdict.find(' '));
}

std::string without_blanks(std::string_view text) {
  static const std::regex blank("\\s+");
  return std::regex_replace(std::string(text), blank, "");
}

}  // namespace literate
