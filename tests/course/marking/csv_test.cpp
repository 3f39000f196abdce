// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/marking/csv.hpp"

#include <boost/test/unit_test.hpp>

#include "message_of.hpp"
#include "system/error.hpp"

BOOST_AUTO_TEST_SUITE(csv_test)

using course::csv_field;
using course::parse_csv;

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

BOOST_AUTO_TEST_CASE(what_is_read_is_what_was_written_with_its_place) {
  const std::string text =
      "\xEF\xBB\xBFid, says\r\n\r\n" + csv_field("a,\"b\"\nc") + ",  two words \n";

  const auto rows = parse_csv(text, "x.csv");

  BOOST_REQUIRE(rows.size() == 2U);
  BOOST_TEST(rows[0][1].text == "says");
  BOOST_TEST(rows[0][1].place == "x.csv:1:5");
  BOOST_TEST(rows[1][0].text == "a,\"b\"\nc");
  BOOST_TEST(rows[1][0].place == "x.csv:3:1");
  BOOST_TEST(rows[1][1].text == "two words");
  BOOST_TEST(rows[1][1].place == "x.csv:4:6");
}

BOOST_AUTO_TEST_CASE(what_is_no_csv_is_told_with_line_and_column) {
  const auto message = [](const char* text) {
    return message_of<sys::SourceError>([&] { parse_csv(text, "x.csv"); });
  };

  BOOST_TEST(message("a,b\n1,\"2\n") == "x.csv:2:3: a quote is not closed");
  BOOST_TEST(message("a,b\n1,\"2\" 3\n") ==
             "x.csv:2:7: there is text behind a quote that is closed");
  BOOST_TEST(message("a,b\n1,2,3\n") == "x.csv:2:1: the line has 3 fields, the first one has 2");
  BOOST_TEST(parse_csv("", "x.csv").empty());
}

BOOST_AUTO_TEST_SUITE_END()
