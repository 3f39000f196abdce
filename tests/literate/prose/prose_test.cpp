// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/prose/prose.hpp"

#include <boost/test/unit_test.hpp>
#include <string>

BOOST_AUTO_TEST_SUITE(prose_test)

using namespace literate;

namespace {

// The words of the prose, one blank between them, marks as <u>, <q> and <c>.
std::string words_of(const std::string& latex) {
  std::string words;
  for (const char c : prose_of(latex).text) {
    if (c == Prose::upright) words += "<u>";
    if (c == Prose::quantity) words += "<q>";
    if (c == Prose::citation) words += "<c>";
    const bool is_blank = c == ' ' || c == '\n';
    if (is_blank && !words.empty() && words.back() != ' ') words += ' ';
    if (!is_blank && c >= ' ') words += c;
  }
  return words.ends_with(' ') ? words.substr(0, words.size() - 1) : words;
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_prose_keeps_the_places_of_its_text) {
  const std::string latex = "\\section{One}\n\\val{key} is % why\n\\emph{two}.";
  const Prose prose = prose_of(latex);

  BOOST_TEST(prose.text == "        {One}\n          is      \n     {two}.");
  BOOST_TEST(prose.modes.size() == latex.size());
}

BOOST_AUTO_TEST_CASE(arguments_that_are_not_printed_are_taken_out) {
  BOOST_TEST(words_of("\\textcolor{red}{a}\\href{b}{c}\\rule[1mm]{2mm}{3mm}d\\\\[4mm]e") ==
             "{a} {c} d e");
  BOOST_TEST(words_of("\\begin{tabular}[t]{lp{1cm}}a & b\\end{tabular}\\begin{figure}[ht]c") ==
             "a & b c");
  BOOST_TEST(words_of("\\includegraphics[width=3cm]{pictures/rig.png}a\\fig[width=9cm]{b}c") ==
             "a c");
}

BOOST_AUTO_TEST_CASE(what_is_not_the_document_is_taken_out) {
  BOOST_TEST(words_of("\\geometry{x=y}\\begin{document}a\\end{document}") == "a");
  BOOST_TEST(words_of("a\\begin{thebibliography}{9}b\\end{thebibliography}c") == "a c");
  BOOST_TEST(words_of("a\\verb|b|c\\begin{verbatim}d\\end{verbatim}e") == "a c e");
}

BOOST_AUTO_TEST_CASE(commands_that_matter_to_numbers_leave_a_mark) {
  BOOST_TEST(words_of("\\mathrm{mm}") == "<u> {mm}");
  BOOST_TEST(words_of("\\qty{2}{mm}") == "<q> {2}{mm}");
  BOOST_TEST(words_of("see \\cite[p. 3]{a}, 4") == "see <c> , 4");
}

BOOST_AUTO_TEST_CASE(symbols_that_may_stand_before_a_unit_stay) {
  BOOST_TEST(words_of("5\\% 4\\,N \\& \\{a\\}") == "5\\% 4\\,N a");
}

BOOST_AUTO_TEST_CASE(each_character_has_its_mode) {
  const std::string latex = "a$b$\\[c\\]\\begin{align}d\\end{align}";
  const Prose prose = prose_of(latex);

  BOOST_CHECK(prose.modes[latex.find('a')] == TexMode::text);
  BOOST_CHECK(prose.modes[latex.find("b$")] == TexMode::inline_math);
  BOOST_CHECK(prose.modes[latex.find('c')] == TexMode::display_math);
  BOOST_CHECK(prose.modes[latex.find("d\\end")] == TexMode::display_math);
}

BOOST_AUTO_TEST_SUITE_END()
