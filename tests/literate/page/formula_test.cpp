// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/page/formula.hpp"

#include <boost/test/unit_test.hpp>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(formula_test)

using namespace literate;

namespace {

struct Written {
  std::string html;
  std::vector<std::string> complaints;
};

Written written(const std::string& latex, const std::string& preamble = {}) {
  Written result;
  TexReader reader;
  reader.push(page_tokens(preamble));
  while (const auto token = reader.next()) reader.read_definition(token->text);
  const FormulaSurroundings surroundings{
      .text = [](const PageTokens& tokens) { return latex_of_tokens(tokens); },
      .command =
          [&](const PageToken& token, std::string& html) {
            if (token.text != "val") return false;
            html = "value " + latex_of_tokens(reader.argument());
            return true;
          },
      .complain =
          [&](const PageToken& token, const std::string& message) {
            result.complaints.push_back(token.text + " " + message);
          }};
  result.html = Formula(reader, surroundings).mathml(page_tokens(latex));
  return result;
}

std::string mathml(const std::string& latex, const std::string& preamble = {}) {
  return written(latex, preamble).html;
}

}  // namespace

BOOST_AUTO_TEST_CASE(letters_numbers_and_operators_are_elements_of_their_kind) {
  BOOST_TEST(mathml("a+12.5") == "<mi>a</mi><mo>+</mo><mn>12.5</mn>");
  BOOST_TEST(mathml("1.") == "<mn>1</mn><mo lspace=\"0em\" rspace=\"0em\">.</mo>");
}

BOOST_AUTO_TEST_CASE(a_minus_is_a_sign_where_nothing_stands_before_it) {
  const std::string sign = "<mo form=\"prefix\">\u2212</mo>";

  BOOST_TEST(mathml("-x") == sign + "<mi>x</mi>");
  BOOST_TEST(mathml("a=-x") == "<mi>a</mi><mo>=</mo>" + sign + "<mi>x</mi>");
  BOOST_TEST(mathml("a-x") == "<mi>a</mi><mo>\u2212</mo><mi>x</mi>");
}

BOOST_AUTO_TEST_CASE(scripts_belong_to_the_atom_before_them) {
  BOOST_TEST(mathml("x_1^2") == "<msubsup><mi>x</mi><mn>1</mn><mn>2</mn></msubsup>");
  BOOST_TEST(mathml("u_{z1}") == "<msub><mi>u</mi><mrow><mi>z</mi><mn>1</mn></mrow></msub>");
  BOOST_TEST(mathml("f'") == "<msup><mi>f</mi><mo lspace=\"0em\" rspace=\"0em\">′</mo></msup>");
}

BOOST_AUTO_TEST_CASE(a_brace_embraces_all_of_its_argument_and_its_label_stands_below) {
  BOOST_TEST(
      mathml("\\underbrace{a+b}_{c}") ==
      "<munder><munder><mrow><mi>a</mi><mo>+</mo><mi>b</mi></mrow><mo stretchy=\"true\">⏟</mo>"
      "</munder><mi>c</mi></munder>");
}

BOOST_AUTO_TEST_CASE(limits_of_a_sum_stand_below_and_of_an_integral_beside) {
  BOOST_TEST(mathml("\\sum_i").starts_with("<munder><mo>∑</mo>"));
  BOOST_TEST(mathml("\\int_0^1").starts_with("<msubsup><mo>∫</mo>"));
}

BOOST_AUTO_TEST_CASE(fractions_take_groups_single_tokens_and_commands) {
  const std::string half = "<mfrac><mn>1</mn><mi>π</mi></mfrac>";

  BOOST_TEST(mathml("\\frac{1}{\\pi}") == half);
  BOOST_TEST(mathml("\\frac1\\pi") == half);
}

BOOST_AUTO_TEST_CASE(delimiters_stretch_between_left_and_right_alone) {
  BOOST_TEST(mathml("\\left(\\frac12\\right)").find("stretchy=\"true\"") != std::string::npos);
  BOOST_TEST(mathml("(a)").find("stretchy=\"true\"") == std::string::npos);
}

BOOST_AUTO_TEST_CASE(a_function_is_parted_from_its_argument_but_not_from_a_parenthesis) {
  const std::string thin = "<mspace width=\"0.1667em\"></mspace>";

  BOOST_TEST(mathml("\\ln x") == "<mi>ln</mi>" + thin + "<mi>x</mi>");
  BOOST_TEST(mathml("\\ln(x)").find("<mspace") == std::string::npos);
}

BOOST_AUTO_TEST_CASE(alphabets_are_those_of_unicode) {
  BOOST_TEST(mathml("\\mathbf{x}") == "<mi>𝐱</mi>");
  BOOST_TEST(mathml("\\mathbb{R}") == "<mi>ℝ</mi>");
  BOOST_TEST(mathml("\\mathrm{d}") == "<mi mathvariant=\"normal\">d</mi>");
  BOOST_TEST(mathml("\\mathrm{max}") == "<mi>max</mi>");
}

BOOST_AUTO_TEST_CASE(the_documents_own_commands_are_expanded) {
  BOOST_TEST(mathml("\\uz^2", "\\newcommand*\\uz{u_z}").find("<mi>u</mi>") != std::string::npos);
  BOOST_TEST(mathml("\\half{x}", "\\newcommand\\half[1]{\\frac{#1}{2}}") ==
             "<mfrac><mi>x</mi><mn>2</mn></mfrac>");
}

BOOST_AUTO_TEST_CASE(commands_of_the_page_are_text_in_the_formula) {
  BOOST_TEST(mathml("x=\\val{key}") == "<mi>x</mi><mo>=</mo><mtext>value key</mtext>");
}

BOOST_AUTO_TEST_CASE(rows_and_cells_are_parted_outside_braces_and_environments) {
  const auto rows =
      formula_rows(page_tokens("a&{b&c}\\\\[4pt]\\begin{cases}d&e\\end{cases}&f\\\\"));

  BOOST_REQUIRE(rows.size() == 2U);
  BOOST_TEST(rows[0].size() == 2U);
  BOOST_TEST(rows[1].size() == 2U);
  BOOST_TEST(latex_of_tokens(rows[1][1]) == "f");
}

BOOST_AUTO_TEST_CASE(cases_have_a_brace_on_the_left_and_none_on_the_right) {
  const std::string html = mathml("\\begin{cases}a&b\\\\c&d\\end{cases}");

  BOOST_TEST(html.find(">{</mo><mtable>") != std::string::npos);
  BOOST_TEST(html.ends_with("</mtable></mrow>"));
}

BOOST_AUTO_TEST_CASE(what_is_not_known_is_told) {
  const Written result = written("\\unknown{x}");

  BOOST_REQUIRE(result.complaints.size() == 1U);
  BOOST_TEST(result.complaints.front() == "unknown is not known to formulas of the page");
}

BOOST_AUTO_TEST_SUITE_END()
