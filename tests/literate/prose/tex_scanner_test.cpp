// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/prose/tex_scanner.hpp"

#include <boost/test/unit_test.hpp>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(tex_scanner_test)

using namespace literate;
using Texts = std::vector<std::string_view>;
using boost::test_tools::per_element;

namespace {

std::vector<TexToken> tokens_of(std::string_view latex) {
  std::vector<TexToken> tokens;
  TexScanner scanner(latex);
  while (const auto token = scanner.next()) tokens.push_back(*token);
  return tokens;
}

// The texts of all tokens of one kind.
Texts texts_of(TexKind kind, std::string_view latex) {
  Texts texts;
  for (const TexToken& token : tokens_of(latex)) {
    if (token.kind == kind) texts.push_back(token.text);
  }
  return texts;
}

// A letter for the mode in which each of the words a, b, … is read.
std::string modes_of_words(std::string_view latex) {
  std::string modes;
  for (const TexToken& token : tokens_of(latex)) {
    if (token.kind == TexKind::text) modes += "tid"[static_cast<int>(token.mode)];
  }
  return modes;
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_tokens_together_are_the_text) {
  const std::string latex =
      "a\\b*{c} % d\n\\begin{align}$$\\[\\%\\verb|}|\\begin{verbatim}x\n{\\end{verbatim}\\";
  std::string together;
  for (const TexToken& token : tokens_of(latex)) together += token.text;
  BOOST_TEST(together == latex);
}

BOOST_AUTO_TEST_CASE(a_comment_ends_with_its_line_and_an_escaped_sign_begins_none) {
  BOOST_TEST(texts_of(TexKind::comment, "50\\% a % b \\c\nd\\\\% e") == (Texts{"% b \\c", "% e"}),
             per_element());
}

BOOST_AUTO_TEST_CASE(a_command_has_a_name_of_letters_and_its_star) {
  const auto tokens = tokens_of("\\vspace*{x}\\lit@use2\\%");
  BOOST_TEST(tokens.front().name == "vspace");
  BOOST_TEST(
      texts_of(TexKind::command, "\\vspace*{x}\\lit@use2\\%") == (Texts{"\\vspace*", "\\lit@use"}),
      per_element());
  BOOST_TEST(texts_of(TexKind::symbol, "\\%\\\\[1mm]\\[x\\") == (Texts{"\\%", "\\\\", "\\[", "\\"}),
             per_element());
}

BOOST_AUTO_TEST_CASE(nothing_within_verbatim_text_is_read) {
  BOOST_TEST(texts_of(TexKind::verbatim, "\\verb|\\a%{| \\verb*+$+\\verb|open\nnext") ==
                 (Texts{"\\verb|\\a%{|", "\\verb*+$+", "\\verb|open"}),
             per_element());
  const std::string listing = "\\begin{lstlisting}\n% {\\end{verbatim}\n\\end{lstlisting}";
  BOOST_TEST(texts_of(TexKind::verbatim, listing + "\\begin{verbatim}to the end") ==
                 (Texts{listing, "\\begin{verbatim}to the end"}),
             per_element());
}

BOOST_AUTO_TEST_CASE(a_per_cent_sign_in_an_address_begins_no_comment) {
  const std::string latex = "\\url{a%20b} \\href{c%7Ed}{e} \\nolinkurl{f}% g";

  BOOST_TEST(texts_of(TexKind::verbatim, latex) ==
                 (Texts{"\\url{a%20b}", "\\href{c%7Ed}", "\\nolinkurl{f}"}),
             per_element());
  BOOST_TEST(texts_of(TexKind::comment, latex) == (Texts{"% g"}), per_element());
}

BOOST_AUTO_TEST_CASE(environments_begin_and_end_by_name) {
  const auto tokens = tokens_of("\\begin{figure}[ht]\\end {figure}");
  BOOST_REQUIRE(tokens.size() == 3U);
  BOOST_CHECK(tokens[0].kind == TexKind::begin);
  BOOST_CHECK(tokens[2].kind == TexKind::end);
  BOOST_TEST(tokens[0].name == "figure");
  BOOST_TEST(tokens[2].name == "figure");
}

BOOST_AUTO_TEST_CASE(mathematics_is_told_from_text_however_it_is_marked) {
  BOOST_TEST(modes_of_words("a$b$c$$d$$e") == "titdt");
  BOOST_TEST(modes_of_words("$a$$b$c") == "iit");
  BOOST_TEST(modes_of_words("\\(a\\)b\\[c\\]d\\\\[e]") == "itdtt");
  BOOST_TEST(modes_of_words("\\begin{align*}a\\end{align*}b\\begin{center}c") == "dtt");
}

BOOST_AUTO_TEST_CASE(a_group_ends_with_its_own_delimiter) {
  BOOST_TEST(group_at(" {a{b}\\}c}d}") == " {a{b}\\}c}");
  BOOST_TEST(group_at("[2pt]{x}", '[', ']') == "[2pt]");
  BOOST_TEST(group_at("a{b}").empty());
  BOOST_TEST(group_at("{open").empty());
}

BOOST_AUTO_TEST_CASE(an_argument_stands_on_its_line_without_blanks) {
  BOOST_TEST(argument_at(" { key.x }{b}") == "key.x");
  BOOST_TEST(argument_at("{a\n}").empty());
  BOOST_TEST(argument_at("\n{a}").empty());
}

BOOST_AUTO_TEST_CASE(a_place_counts_lines_and_characters_from_one) {
  const std::string text = "one\nνξ here";
  const TexPlace place = place_in(text, std::string_view(text).substr(text.find("here")));
  BOOST_TEST(place.line == 2);
  BOOST_TEST(place.column == 4);
  BOOST_TEST(place_in(text, text).line == 1);
  BOOST_TEST(place_in(text, text).column == 1);
}

BOOST_AUTO_TEST_CASE(what_a_reader_skips_is_no_token) {
  TexScanner scanner("\\a{\\b}\\c");
  scanner.next();
  BOOST_TEST(scanner.skip(group_at(scanner.rest()).size()) == "{\\b}");
  BOOST_TEST(scanner.next()->name == "c");
  BOOST_TEST(scanner.skip(5).empty());
  BOOST_TEST(!scanner.next().has_value());
}

BOOST_AUTO_TEST_SUITE_END()
