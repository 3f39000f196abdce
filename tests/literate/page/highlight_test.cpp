// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/page/highlight.hpp"

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(highlight_test)

using namespace literate;

BOOST_AUTO_TEST_CASE(every_line_has_its_number_in_the_file) {
  BOOST_TEST(highlighted("a\n\nb\n", "", 25) ==
             "<span class=\"lit-line\" data-line=\"25\">a</span>\n"
             "<span class=\"lit-line\" data-line=\"26\"></span>\n"
             "<span class=\"lit-line\" data-line=\"27\">b</span>\n");
}

BOOST_AUTO_TEST_CASE(keywords_comments_and_strings_are_told_apart) {
  const std::string html = highlighted("return \"// if\"; // if <x>", "[20]C++", 1);

  BOOST_TEST(html.find("<span class=\"lit-keyword\">return</span>") != std::string::npos);
  BOOST_TEST(html.find("<span class=\"lit-string\">&quot;// if&quot;</span>") != std::string::npos);
  BOOST_TEST(html.find("<span class=\"lit-comment\">// if &lt;x&gt;</span>") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(a_comment_over_lines_is_one_on_each) {
  const std::string html = highlighted("/* a\nb */ c", "C", 1);

  BOOST_TEST(html.find("<span class=\"lit-comment\">b */</span> c") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(a_transpose_and_grouped_digits_begin_no_string) {
  BOOST_TEST(highlighted("A' * b", "Octave", 1).find("lit-string") == std::string::npos);
  BOOST_TEST(highlighted("n = 1'000'000;", "C++", 1).find("lit-string") == std::string::npos);
}

BOOST_AUTO_TEST_CASE(languages_have_the_names_that_readers_know) {
  BOOST_TEST(language_name("[20]C++") == "C++");
  BOOST_TEST(language_name("Octave") == "Octave");
}

BOOST_AUTO_TEST_SUITE_END()
