// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/page/html_text.hpp"

#include <boost/algorithm/string/replace.hpp>
#include <utility>

#include "literate/text/characters.hpp"
#include "system/pattern.hpp"
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
std::string with_plain_numbers(std::string_view html) {
  static const sys::Pattern fraction("<mfrac><m[in]>([^<]*)</m[in]><m[in]>([^<]*)</m[in]></mfrac>");
  static const sys::Pattern shift(
      "<(su[pb])>([^<]*)</su[pb]>|"
      "(?:<mrow><mo[^>]*>(−)</mo><mn>([0-9]+)</mn></mrow>|<mn>([0-9]+)</mn>)"
      "</m(su[pb])>");
  const std::string with_fractions = fraction.replaced_in(html, "$1/$2");
  std::string_view rest = with_fractions;
  std::string text;
  for (const sys::Pattern::Match& found : shift.all_in(with_fractions)) {
    const bool is_raised = found.parts[1] == "sup" || found.parts[6] == "sup";
    const std::string inside = found.str(2) + found.str(3) + found.str(4) + found.str(5);
    const std::string made = shifted(inside, is_raised);
    text.append(found.before).append(made.empty() ? inside : made);
    rest = found.rest;
  }
  return text.append(rest);
}

}  // namespace

std::string text_of_html(std::string_view html) {
  static const sys::Pattern space("<mspace[^>]*>"), tag("<[^>]*>");
  const std::string numbers = with_plain_numbers(space.replaced_in(html, " "));
  return sys::one_line(tag.replaced_in(numbers, ""));
}

std::string one_word(const std::string& verdict) {
  return verdict.substr(0, verdict.find(' '));
}

std::string without_blanks(std::string_view text) {
  static const sys::Pattern blank("\\s+");
  return blank.replaced_in(text, "");
}

}  // namespace literate
