// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/utf8.hpp"

#include <boost/test/unit_test.hpp>
#include <string>
#include <utility>

BOOST_AUTO_TEST_SUITE(utf8_test)

using namespace sys;

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

BOOST_AUTO_TEST_SUITE_END()
