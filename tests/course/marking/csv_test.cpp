// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/marking/csv.hpp"

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(csv_test)

using course::csv_field;

BOOST_AUTO_TEST_CASE(a_plain_field_stays_as_it_is) {
  BOOST_TEST(csv_field("plain") == "plain");
  BOOST_TEST(csv_field("").empty());
  BOOST_TEST(csv_field("two words") == "two words");
}

BOOST_AUTO_TEST_CASE(a_field_with_a_comma_a_quote_or_a_line_end_is_quoted) {
  BOOST_TEST(csv_field("a,\"b\"") == "\"a,\"\"b\"\"\"");
  BOOST_TEST(csv_field("a\nb") == "\"a\nb\"");
  BOOST_TEST(csv_field("a\rb") == "\"a\rb\"");
}

BOOST_AUTO_TEST_CASE(no_field_is_a_formula_of_a_spreadsheet) {
  for (const char* formula : {"=1+1", "+1", "-1", "@cmd"}) {
    BOOST_TEST(csv_field(formula) == std::string("'") + formula);
  }
  BOOST_TEST(csv_field("@cmd,x") == "\"'@cmd,x\"");
  BOOST_TEST(csv_field("a=1") == "a=1");
}

BOOST_AUTO_TEST_SUITE_END()
