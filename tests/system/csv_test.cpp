// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/csv.hpp"

#include <boost/test/unit_test.hpp>
#include <string>

BOOST_AUTO_TEST_SUITE(csv_test)

using sys::csv_field;

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
  BOOST_TEST(sys::csv_line({"", "a,b", "c"}) == ",\"a,b\",c\n");
}

BOOST_AUTO_TEST_SUITE_END()
