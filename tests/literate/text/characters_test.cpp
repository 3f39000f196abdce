// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/text/characters.hpp"

#include <boost/test/unit_test.hpp>
#include <stdexcept>

#include "message_of.hpp"

BOOST_AUTO_TEST_SUITE(characters_test)

using namespace literate;

BOOST_AUTO_TEST_CASE(a_key_is_made_of_letters_digits_and_three_signs) {
  for (const char* key : {"a", "7", "peak.pressure-2_x"}) BOOST_TEST(is_key(key), key);
  for (const char* text : {"", ".a", "-a", "a b", "a/b", "é"}) BOOST_TEST(!is_key(text), text);
}

BOOST_AUTO_TEST_CASE(a_file_name_is_a_key_without_a_dot) {
  BOOST_TEST(is_file_name("table-2_x"));
  BOOST_TEST(!is_file_name("table.2"));
  BOOST_TEST(!is_file_name("../table"));
}

BOOST_AUTO_TEST_CASE(what_is_neither_is_named) {
  BOOST_TEST(message_of<std::logic_error>([] { require_key("a b"); }) ==
             "key 'a b' must be letters, digits, '-', '_' and '.'");
  BOOST_TEST(message_of<std::logic_error>([] { require_file_name("a.b"); }) ==
             "name 'a.b' must be letters, digits, '-' and '_'");
}

BOOST_AUTO_TEST_SUITE_END()
