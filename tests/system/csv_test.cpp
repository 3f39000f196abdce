// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/csv.hpp"

#include <boost/test/unit_test.hpp>
#include <string>

#include "message_of.hpp"
#include "system/error.hpp"

BOOST_AUTO_TEST_SUITE(csv_test)

using namespace std::string_literals;
using sys::csv_field;
using sys::parse_csv;
using sys::spreadsheet_field;

BOOST_AUTO_TEST_CASE(a_plain_field_stays_as_it_is) {
  for (const char* plain : {"plain", "", "two words", "a=1", "-1"}) {
    BOOST_TEST(csv_field(plain) == plain);
  }
}

BOOST_AUTO_TEST_CASE(a_field_that_would_not_come_back_is_quoted) {
  BOOST_TEST(csv_field("a,\"b\"") == "\"a,\"\"b\"\"\"");
  BOOST_TEST(csv_field("\"\"\"") == "\"\"\"\"\"\"\"\"");
  for (const char* text : {"a\nb", "a\rb", "# none", " blank", "blank\t"}) {
    BOOST_TEST(csv_field(text) == "\"" + std::string(text) + "\"");
    const auto rows = parse_csv(csv_field(text), "x.csv", sys::CsvComments::number_sign);
    BOOST_REQUIRE(rows.size() == 1U);
    BOOST_TEST(rows[0][0].text == text);
  }
  BOOST_TEST(sys::csv_line({"", "a,b", "c"}) == ",\"a,b\",c\n");
}

BOOST_AUTO_TEST_CASE(no_field_is_a_formula_of_a_spreadsheet) {
  for (const char* formula : {"=1+1", "+1", "-1", "@cmd"}) {
    BOOST_TEST(spreadsheet_field(formula) == "'"s + formula);
  }
  BOOST_TEST(spreadsheet_field("@cmd,x") == "\"'@cmd,x\"");
  BOOST_TEST(spreadsheet_field("a=1") == "a=1");
}

BOOST_AUTO_TEST_CASE(what_is_read_is_what_was_written_with_its_place) {
  const std::string text =
      "\xEF\xBB\xBFid, says,\r\n\r\n" + csv_field("a,\"b\"\nc") + ",  two words ,\n \t\n  x,\"\",";

  const auto rows = parse_csv(text, "x.csv");

  BOOST_REQUIRE(rows.size() == 3U);
  BOOST_TEST(rows[0][1].text == "says");
  BOOST_TEST(rows[0][1].place == "x.csv:1:5");
  BOOST_TEST(rows[0][2].place == "x.csv:1:10");
  BOOST_TEST(rows[1][0].text == "a,\"b\"\nc");
  BOOST_TEST(rows[1][0].place == "x.csv:3:1");
  BOOST_TEST(rows[1][1].text == "two words");
  BOOST_TEST(rows[1][1].place == "x.csv:4:6");
  BOOST_TEST(rows[2][0].line == 6U);
  BOOST_TEST(rows[2][0].place == "x.csv:6:3");
  BOOST_TEST(rows[2][2].place == "x.csv:6:8");
}

BOOST_AUTO_TEST_CASE(comments_are_passed_over_where_a_line_begins_with_one) {
  const std::string text = "# a \"note\nx,y\n#1,2\n\"a\n# b\",# c\n#\n# the end";

  const auto rows = parse_csv(text, "x.csv", sys::CsvComments::number_sign);

  BOOST_REQUIRE(rows.size() == 3U);
  BOOST_TEST(rows[1][0].text == "#1");
  BOOST_TEST(rows[2][0].text == "a\n# b");
  BOOST_TEST(rows[2][0].place == "x.csv:4:1");
  BOOST_TEST(rows[2][1].text == "# c");
  BOOST_TEST(parse_csv("# 1\n", "x.csv").size() == 1U);
}

BOOST_AUTO_TEST_CASE(what_is_no_csv_is_told_with_line_and_column) {
  const auto message = [](const std::string& text) {
    return message_of<sys::SourceError>([&] { parse_csv(text, "x.csv"); });
  };

  BOOST_TEST(message("a,b\n1,\"2\n") == "x.csv:2:3: a quote is not closed");
  BOOST_TEST(message("a,b\n1,\"2\" 3\n") ==
             "x.csv:2:7: there is text behind a quote that is closed");
  BOOST_TEST(message("a,b\n1,2\"\n") == "x.csv:2:4: a quote stands within a field that has none");
  BOOST_TEST(message("a,b\n1,2,3\n") == "x.csv:2:1: the line has 3 fields, the first one has 2");
  BOOST_TEST(message("a,b\n1") == "x.csv:2:1: the line has 1 field, the first one has 2");
  BOOST_TEST(message("a\n1\0\n"s) == "x.csv:2:2: there is a zero byte");
  BOOST_TEST(parse_csv("", "x.csv").empty());
}

BOOST_AUTO_TEST_SUITE_END()
