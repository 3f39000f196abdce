// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/pattern.hpp"

#include <boost/test/unit_test.hpp>
#include <regex>
#include <string>

BOOST_AUTO_TEST_SUITE(pattern_test)

using sys::Pattern;

BOOST_AUTO_TEST_CASE(the_first_match_comes_with_its_groups_and_the_rest) {
  const Pattern pattern("([a-z]+)=([0-9]+)(!)?");
  const std::string text = "1: n=17, m=3!";

  const auto match = pattern.find_in(text);

  BOOST_REQUIRE(match.has_value());
  BOOST_TEST(match->parts == (std::vector<std::string_view>{"n=17", "n", "17", ""}),
             boost::test_tools::per_element());
  BOOST_TEST(match->rest == ", m=3!");
  BOOST_TEST(match->parts[0].data() == text.data() + 3);
}

BOOST_AUTO_TEST_CASE(a_match_of_all_tolerates_nothing_beside_it) {
  const Pattern pattern("v([0-9]+)");
  BOOST_TEST(pattern.is_in("on v12 or later"));
  BOOST_TEST(!pattern.is_all_of("on v12 or later"));
  BOOST_REQUIRE(pattern.match_all_of("v12").has_value());
  BOOST_TEST(pattern.match_all_of("v12")->parts.at(1) == "12");
  BOOST_TEST(!pattern.find_in("none").has_value());
}

BOOST_AUTO_TEST_CASE(all_matches_come_with_what_stands_between_them) {
  const auto matches = Pattern("[a-z]=([0-9])").all_in("a=1, b=2;");
  BOOST_REQUIRE(matches.size() == 2);
  BOOST_TEST(matches[0].before == "");
  BOOST_TEST(matches[0].str(1) == "1");
  BOOST_TEST(matches[1].before == ", ");
  BOOST_TEST(matches[1].str() == "b=2");
  BOOST_TEST(matches[1].rest == ";");
  BOOST_TEST(Pattern("x").all_in("none").empty());
}

BOOST_AUTO_TEST_CASE(a_text_is_split_at_each_match) {
  BOOST_TEST(
      Pattern(" *, *").split("a, b ,,c") == (std::vector<std::string_view>{"a", "b", "", "c"}),
      boost::test_tools::per_element());
  BOOST_TEST(Pattern(",").split("a").size() == 1);
}

BOOST_AUTO_TEST_CASE(a_replacement_may_hold_a_group) {
  BOOST_TEST(Pattern("<([a-z])>").replaced_in("<a>1<b>", "($1)") == "(a)1(b)");
  BOOST_TEST(Pattern("x").replaced_in("none", "y") == "none");
}

BOOST_AUTO_TEST_CASE(at_the_begin_nothing_stands_before_a_match) {
  const Pattern number("[0-9]+");
  BOOST_TEST(number.find_at_begin_of("12pt")->rest == "pt");
  BOOST_TEST(!number.find_at_begin_of(" 12pt").has_value());
}

BOOST_AUTO_TEST_CASE(case_counts_unless_it_is_to_be_ignored) {
  BOOST_TEST(!Pattern("error").is_in("Error: none"));
  BOOST_TEST(Pattern("error", true).is_in("Error: none"));
}

BOOST_AUTO_TEST_CASE(an_expression_that_is_none_is_refused) {
  BOOST_CHECK_THROW(Pattern("(open"), std::regex_error);
}

BOOST_AUTO_TEST_SUITE_END()
