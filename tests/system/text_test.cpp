// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/text.hpp"

#include <boost/test/unit_test.hpp>
#include <string>

BOOST_AUTO_TEST_SUITE(text_test)

using namespace sys;
using Lines = std::vector<std::string_view>;

BOOST_AUTO_TEST_CASE(lines_come_without_either_kind_of_end) {
  BOOST_TEST(lines_of("one\ntwo\r\n\nfour") == (Lines{"one", "two", "", "four"}),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_last_line_end_starts_no_line) {
  BOOST_TEST(lines_of("").empty());
  BOOST_TEST(lines_of("one\n") == Lines{"one"}, boost::test_tools::per_element());
  BOOST_TEST(lines_of("\n\n") == (Lines{"", ""}), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(only_blanks_at_the_ends_are_stripped) {
  BOOST_TEST(stripped(" \t a b\tc \t") == "a b\tc");
  BOOST_TEST(stripped("\r\na\nb\r\n") == "a\nb");
  BOOST_TEST(stripped(" \t ").empty());
}

BOOST_AUTO_TEST_CASE(one_line_has_the_words_with_a_blank_between_them) {
  BOOST_TEST(one_line(" \n one  two\r\n\tthree \n") == "one two three");
  BOOST_TEST(one_line(" \n").empty());
}

BOOST_AUTO_TEST_SUITE_END()
