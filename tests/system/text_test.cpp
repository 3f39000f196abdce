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

BOOST_AUTO_TEST_CASE(a_plain_field_is_not_changed) {
  for (const char* plain : {"plain", "", "two words", "a=1", "-1"}) {
    BOOST_TEST(csv_field(plain) == plain);
  }
}

BOOST_AUTO_TEST_CASE(a_field_with_special_characters_is_quoted) {
  BOOST_TEST(csv_field("a,\"b\"") == "\"a,\"\"b\"\"\"");
  for (const char* text : {"a\nb", "a\rb", "# none", " blank", "blank\t"}) {
    BOOST_TEST(csv_field(text) == "\"" + std::string(text) + "\"");
  }
  BOOST_TEST(csv_line({"", "a,b", "c"}) == ",\"a,b\",c\n");
}

BOOST_AUTO_TEST_CASE(only_a_similar_name_is_suggested) {
  BOOST_TEST(suggestion("lenght", {"length", "width"}) == ", did you mean 'length'?");
  BOOST_TEST(suggestion("mass", {"length", "width"}) == "");
  BOOST_TEST(suggestion("ab", {"cd"}) == "");
  BOOST_TEST(suggestion("x", {}) == "");
}

BOOST_AUTO_TEST_SUITE_END()
