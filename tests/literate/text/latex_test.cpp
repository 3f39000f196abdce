// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/text/latex.hpp"

#include <boost/test/unit_test.hpp>
#include <stdexcept>

#include "messages.hpp"

using literate::author_latex;
using literate::latex_escaped;

BOOST_AUTO_TEST_SUITE(latex_test)

BOOST_AUTO_TEST_CASE(plain_text_is_escaped_character_by_character) {
  BOOST_TEST(latex_escaped("50 % of A_1 & B{2}") == "50 \\% of A\\_1 \\& B\\{2\\}");
  BOOST_TEST(latex_escaped("\\~^<>|") ==
             "\\textbackslash{}\\textasciitilde{}\\textasciicircum{}\\textless{}\\textgreater{}"
             "\\textbar{}");
  BOOST_TEST(latex_escaped("Müller – 3 µm\tx\n") == "Müller – 3 µm x ");
}

BOOST_AUTO_TEST_CASE(escaped_text_has_no_ligatures) {
  BOOST_TEST(latex_escaped("--nodes 91") == "-{}-nodes 91");
  BOOST_TEST(latex_escaped("a---b") == "a-{}-{}-b");
  BOOST_TEST(latex_escaped("?`x ,,y ''q'' \"") ==
             "?\\textasciigrave{}x ,{},y '{}'q'{}' \\char34{}");
  BOOST_TEST(latex_escaped("<<z>>") == "\\textless{}\\textless{}z\\textgreater{}\\textgreater{}");
}

BOOST_AUTO_TEST_CASE(a_percent_sign_starts_no_comment) {
  BOOST_TEST(author_latex("share in %") == "share in \\%");
  BOOST_TEST(author_latex("share in \\%") == "share in \\%");
  BOOST_TEST(author_latex("a \\\\% b") == "a \\\\\\% b");
}

BOOST_AUTO_TEST_CASE(unbalanced_latex_is_refused) {
  const auto refused = [](const char* text) {
    return message_of<std::invalid_argument>([=] { author_latex(text); });
  };
  BOOST_TEST(holds(refused("a{b"), "braces of 'a{b' do not match"));
  BOOST_TEST(holds(refused("a}b{"), "do not match"));
  BOOST_TEST(holds(refused("a\\"), "ends with a backslash"));
  BOOST_TEST(holds(refused("caf\xe9"), "the text 'caf…' is not UTF-8"));
  BOOST_TEST(author_latex("\\{ {a} \\}") == "\\{ {a} \\}");
}

BOOST_AUTO_TEST_SUITE_END()
