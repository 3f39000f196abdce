// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/changes/sentences.hpp"

#include <boost/test/unit_test.hpp>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(sentences_test)

using literate::Sentence;
using literate::sentences_in;

namespace {

std::vector<std::string> texts(const std::string& latex) {
  std::vector<std::string> found;
  for (const Sentence& sentence : sentences_in(latex, "a.tex")) found.push_back(sentence.latex);
  return found;
}

void check_texts(const std::string& latex, const std::vector<std::string>& expected) {
  const auto found = texts(latex);
  BOOST_TEST(found == expected, boost::test_tools::per_element());
}

}  // namespace

BOOST_AUTO_TEST_CASE(full_stops_and_empty_lines_end_a_sentence) {
  check_texts("One is\nhere. Two is not!  Three\n\nFour",
              {"One is here.", "Two is not!", "Three", "Four"});
}

BOOST_AUTO_TEST_CASE(a_sentence_begins_behind_the_braces_of_the_one_before) {
  const auto found = sentences_in("\\footnote{One.}\n\nTwo is here.\n", "a.tex");
  BOOST_REQUIRE(found.size() == 2U);
  BOOST_TEST(found[1].latex == "Two is here.");
  BOOST_TEST(found[1].first_line == 3);
}

BOOST_AUTO_TEST_CASE(abbreviations_decimals_and_file_names_do_not) {
  check_texts("See Fig. \\ref{a} and eq. (2), e.g. 1.5 of Contact.m alone. Next.",
              {"See Fig. \\ref{a} and eq. (2), e.g. 1.5 of Contact.m alone.", "Next."});
}

BOOST_AUTO_TEST_CASE(headings_items_and_environments_end_a_sentence) {
  check_texts(
      "\\section{Results}\nNo stop here\n\\begin{itemize}\n\\item first\n\\item second\n"
      "\\end{itemize}\nLast.",
      {"\\section{Results}", "No stop here", "\\item first", "\\item second", "Last."});
}

BOOST_AUTO_TEST_CASE(formulas_and_comments_end_none) {
  check_texts("It is $a. B$ here % not. Here\nand there.", {"It is $a. B$ here and there."});
}

BOOST_AUTO_TEST_CASE(the_preamble_holds_none_but_titles_that_print_something) {
  check_texts("\\title{No. It}\n\\begin{document}\nYes.\n\\end{document}\n", {"Yes."});

  const auto sentences = sentences_in(
      "\\usepackage{a}\n\\title{Of \\val{n}\nrods}\n\\author{A. \\val[digits=2]{name}}\n"
      "\\newcommand\\own{\\val{other}}\n\\begin{document}\nYes.\n\\end{document}\n",
      "a.tex");
  BOOST_TEST_REQUIRE(sentences.size() == 3U);
  BOOST_TEST(sentences[0].names.contains("value n"));
  BOOST_TEST(sentences[0].first_line == 2);
  BOOST_TEST(sentences[1].names.contains("value name"));
  BOOST_TEST(sentences[1].styles.at("value name").contains("digits=2"));
  BOOST_TEST(sentences[1].first_line == 4);
  BOOST_TEST(sentences[2].latex == "Yes.");
}

BOOST_AUTO_TEST_CASE(a_sentence_knows_its_lines_and_what_it_prints) {
  const auto sentences = sentences_in(
      "First.\nThe peak is\n\\val[digits=2]{peak}, see \\claim{one}\nand \\fig{curve}. Last.\n",
      "b.tex");
  BOOST_TEST_REQUIRE(sentences.size() == 3U);
  BOOST_TEST(sentences[1].file == "b.tex");
  BOOST_TEST(sentences[1].first_line == 2);
  BOOST_TEST(sentences[1].last_line == 4);
  const std::set<std::string> names{"value peak", "claim one", "figure curve"};
  BOOST_TEST((sentences[1].names == names));
  BOOST_TEST(sentences[2].names.empty());
}

BOOST_AUTO_TEST_CASE(a_sentence_prints_what_the_documents_own_commands_in_it_print) {
  const auto own = literate::own_commands_in(
      "\\newcommand{\\peak}{\\val{p0}}\\def\\all{\\peak{} and "
      "\\val{p1}}\\renewcommand\\peak{\\val{p2}}");

  const auto sentences = sentences_in("It is \\peak. They are \\all.", "a.tex", {}, own);
  BOOST_TEST_REQUIRE(sentences.size() == 2U);
  BOOST_TEST((sentences[0].names == std::set<std::string>{"value p0", "value p2"}));
  BOOST_TEST((sentences[1].names == std::set<std::string>{"value p0", "value p1", "value p2"}));
}

BOOST_AUTO_TEST_CASE(each_sentence_of_a_branch_knows_its_flag) {
  const auto sentences = sentences_in(
      "None. \\ifflag{wide}{It is wide. It is open.}\n %\n {It is \\ifflag{deep}{deep}{shallow}. "
      "Narrow.} "
      "Last.",
      "a.tex");
  BOOST_TEST_REQUIRE(sentences.size() == 6U);
  const std::set<std::string> wide{"flag wide"}, both{"flag deep", "flag wide"};
  BOOST_TEST(sentences[0].names.empty());
  BOOST_TEST((sentences[1].names == wide));
  BOOST_TEST((sentences[2].names == wide));
  BOOST_TEST((sentences[3].names == both));
  BOOST_TEST((sentences[4].names == wide));
  BOOST_TEST(sentences[5].names.empty());
}

BOOST_AUTO_TEST_CASE(a_sentence_knows_the_heading_above_it) {
  const auto sentences =
      sentences_in("Before.\n\\section{One}\nFirst.\n\\subsection{Two}\nSecond.\n", "a.tex");
  BOOST_TEST_REQUIRE(sentences.size() == 5U);
  BOOST_TEST(sentences[0].heading == "");
  BOOST_TEST(sentences[1].heading == "One");
  BOOST_TEST(sentences[2].first_line == 3);
  BOOST_TEST(sentences[2].heading == "One");
  BOOST_TEST(sentences[3].heading == "Two");
  BOOST_TEST(sentences[4].heading == "Two");
}

BOOST_AUTO_TEST_CASE(a_sentence_prints_no_name_in_a_branch_that_is_not_taken) {
  const auto sentences =
      sentences_in("It is \\ifflag{wide}{\\val{much}}{\\val{little}}.", "a.tex", {{"wide", false}});
  BOOST_TEST_REQUIRE(sentences.size() == 1U);
  const std::set<std::string> names{"flag wide", "value little"};
  BOOST_TEST((sentences[0].names == names));
}

BOOST_AUTO_TEST_SUITE_END()
