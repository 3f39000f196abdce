// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/text.hpp"

#include <boost/test/unit_test.hpp>
#include <string>

BOOST_AUTO_TEST_SUITE(text_test)

using namespace sys;
using Lines = std::vector<std::string_view>;

BOOST_AUTO_TEST_CASE(lines_have_no_line_ends) {
  BOOST_TEST(lines_of("one\ntwo\r\n\nfour") == (Lines{"one", "two", "", "four"}),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_final_line_end_does_not_start_a_line) {
  BOOST_TEST(lines_of("").empty());
  BOOST_TEST(lines_of("one\n") == Lines{"one"}, boost::test_tools::per_element());
  BOOST_TEST(lines_of("\n\n") == (Lines{"", ""}), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(blanks_at_both_ends_are_removed) {
  BOOST_TEST(stripped(" \t a b\tc \t") == "a b\tc");
  BOOST_TEST(stripped("\r\na\nb\r\n") == "a\nb");
  BOOST_TEST(stripped(" \t ").empty());
}

BOOST_AUTO_TEST_CASE(one_line_separates_words_by_one_blank) {
  BOOST_TEST(one_line(" \n one  two\r\n\tthree \n") == "one two three");
  BOOST_TEST(one_line(" \n").empty());
}

BOOST_AUTO_TEST_SUITE_END()
