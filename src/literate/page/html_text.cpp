// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/page/html_text.hpp"

#include <boost/algorithm/string/replace.hpp>
#include <regex>
#include <utility>

#include "literate/text/characters.hpp"
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
  std::string made;
  for (const char sign : boost::replace_all_copy(text, "−", "-")) {
    const std::string_view form = character_of(std::string{is_raised ? '^' : '_', '{', sign, '}'});
    if (form.empty()) return {};
    made += form;
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
  static const std::regex space("<mspace[^>]*>"), tag("<[^>]*>");
  const std::string numbers = with_plain_numbers(std::regex_replace(std::string(html), space, " "));
  return sys::one_line(std::regex_replace(numbers, tag, ""));
}

std::string one_word(const std::string& verdict) {
  return verdict.substr(0, verdict.find(' '));
}

std::string without_blanks(std::string_view text) {
  static const std::regex blank("\\s+");
  return std::regex_replace(std::string(text), blank, "");
}

}  // namespace literate
