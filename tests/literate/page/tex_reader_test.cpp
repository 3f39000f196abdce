// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/page/tex_reader.hpp"

#include <boost/test/unit_test.hpp>
#include <string>

BOOST_AUTO_TEST_SUITE(tex_reader_test)

using namespace literate;

namespace {

// What a text expands to.
std::string expanded(const std::string& latex) {
  TexReader reader;
  reader.push(page_tokens(latex));
  PageTokens result;
  while (const auto token = reader.next()) {
    const bool is_command = token->is(PageToken::Kind::command);
    if (token->is(PageToken::Kind::open)) reader.begin_group();
    if (token->is(PageToken::Kind::close)) reader.end_group();
    if (is_command && (reader.read_definition(token->text) || reader.expand(token->text))) continue;
    result.push_back(*token);
  }
  return latex_of_tokens(result);
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_comment_takes_the_end_of_its_line) {
  BOOST_TEST(latex_of_tokens(page_tokens("a% b\n  c")) == "ac");
  BOOST_TEST(latex_of_tokens(page_tokens("a\\% b")) == "a\\% b");
}

BOOST_AUTO_TEST_CASE(blanks_are_one_and_an_empty_line_ends_the_paragraph) {
  BOOST_TEST(latex_of_tokens(page_tokens("a  \n b")) == "a b");
  BOOST_TEST(latex_of_tokens(page_tokens("a\n \n\n b")) == "a\n\nb");
  BOOST_TEST(latex_of_tokens(page_tokens("a%\n\nb")) == "a\n\nb");
}

BOOST_AUTO_TEST_CASE(blanks_behind_the_name_of_a_command_belong_to_it) {
  const PageTokens tokens = page_tokens("\\alpha  b");

  BOOST_REQUIRE(tokens.size() == 2U);
  BOOST_TEST(tokens[1].text == "b");
}

BOOST_AUTO_TEST_CASE(verbatim_text_is_one_token) {
  const PageTokens tokens = page_tokens("\\verb|a%{b|\\begin{verbatim}\n$x\n\\end{verbatim}");

  BOOST_REQUIRE(tokens.size() == 2U);
  BOOST_TEST(tokens[0].body == "a%{b");
  BOOST_TEST(tokens[1].body == "\n$x\n");
}

BOOST_AUTO_TEST_CASE(places_are_told_from_one) {
  const PageTokens tokens = page_tokens("a\n \\b", 0);

  BOOST_TEST(tokens.back().line == 2);
  BOOST_TEST(tokens.back().column == 2);
}

BOOST_AUTO_TEST_CASE(arguments_take_their_places) {
  BOOST_TEST(expanded("\\newcommand\\two[2]{#2#1}\\two{a}b") == "ba");
  BOOST_TEST(expanded("\\newcommand*\\opt[2][x]{#1#2}\\opt{a}\\opt[b]{c}") == "xabc");
  BOOST_TEST(expanded("\\def\\until#1;#2{[#1|#2]}\\until ab;{c}") == "[ab|c]");
}

BOOST_AUTO_TEST_CASE(a_definition_ends_with_its_group) {
  BOOST_TEST(expanded("\\newcommand\\x{1}{\\renewcommand\\x{2}\\x}\\x") == "{2}1");
}

BOOST_AUTO_TEST_CASE(a_command_that_is_known_is_not_provided_again) {
  BOOST_TEST(expanded("\\newcommand\\x{1}\\providecommand\\x{2}\\x") == "1");
}

BOOST_AUTO_TEST_CASE(let_keeps_what_a_command_was) {
  BOOST_TEST(expanded("\\newcommand\\x{1}\\let\\y=\\x\\renewcommand\\x{2}\\y") == "1");
}

BOOST_AUTO_TEST_CASE(an_environment_may_hold_another_of_its_name) {
  TexReader reader;
  reader.push(page_tokens("a\\begin{e}b\\end{e}c\\end{e}d"));

  BOOST_TEST(latex_of_tokens(reader.environment_body("e")) == "a\\begin{e}b\\end{e}c");
  BOOST_TEST(reader.next()->text == "d");
}

BOOST_AUTO_TEST_SUITE_END()
