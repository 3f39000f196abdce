// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/text.hpp"

#include <boost/test/unit_test.hpp>
#include <string>
#include <utility>

BOOST_AUTO_TEST_SUITE(text_test)

using namespace sys;
using Lines = std::vector<std::string_view>;

BOOST_AUTO_TEST_CASE(a_character_is_taken_whole_with_its_code_point) {
  const std::pair<std::string, char32_t> characters[] = {
      {"a", U'a'}, {"é", U'é'}, {"√", U'√'}, {"𝛼", U'𝛼'}};
  for (const auto& [bytes, code_point] : characters) {
    const std::string text = bytes + "\xCE";  // what follows need not be valid
    const Utf8Character character = first_character(text);
    BOOST_TEST(character.bytes == bytes);
    BOOST_TEST((character.code_point == code_point), bytes);
  }
}

BOOST_AUTO_TEST_CASE(a_byte_of_no_valid_character_stands_alone) {
  const std::string texts[] = {
      "\x80z",             // a byte that continues nothing
      "\xC0\xAF",          // an overlong form of '/'
      "\xCE",              // cut
      "\xE2\x88",          // cut
      "\xED\xA0\x80",      // a surrogate
      "\xF4\x90\x80\x80",  // beyond the last code point
      "\xFFz",
  };
  for (const std::string& text : texts) {
    const Utf8Character character = first_character(text);
    BOOST_TEST(character.bytes == text.substr(0, 1));
    BOOST_TEST(!character.code_point.has_value());
  }
}

BOOST_AUTO_TEST_CASE(a_text_is_as_long_as_the_characters_that_one_sees) {
  BOOST_TEST(n_characters("") == 0U);
  BOOST_TEST(n_characters("νx²√") == 4U);
  BOOST_TEST(n_characters("a\x80\xFFz") == 4U);
}

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
