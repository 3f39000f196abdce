// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/reporting/regrades.hpp"

#include <boost/test/unit_test.hpp>

#include "config/table.hpp"
#include "course/reporting/toy_class.hpp"
#include "message_of.hpp"
#include "system/error.hpp"

BOOST_AUTO_TEST_SUITE(regrades_test)

using namespace course;

namespace {

const std::string granted =
    "student = \"bob\"\ncheck = \"square-values\"\nreason = \"my points are exact\"\n"
    "outcome = \"granted\"\npoints = 5\nanswer = \"so they are\"\nmarker = \"br\"\n";

std::vector<Regrade> read(const std::vector<std::string>& texts) {
  const TemporaryFolder folder;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    folder.write(std::to_string(i) + ".toml", texts[i]);
  }
  folder.write("notes.txt", "no request");
  return read_regrades(toy_grading::assignment(), folder.path());
}

/// The text of a granted request with `before`, which must stand in it, replaced.
std::string with(const std::string& before, const std::string& after) {
  std::string text = granted;
  BOOST_REQUIRE(text.find(before) != std::string::npos);
  return text.replace(text.find(before), before.size(), after);
}

std::string message(const std::vector<std::string>& texts) {
  const std::string what = message_of<config::Error>([&] { read(texts); });
  return what.substr(what.rfind('/') + 1);
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_granted_request_changes_points_deduction_and_mark) {
  ClassMarks marks = toy_class::marks();

  apply_regrades(read({granted}), marks);

  const Mark& bob = *marks.students[1].mark;
  BOOST_TEST(bob.checks.at("square-values") == 5);
  BOOST_TEST(bob.points == 9);
  BOOST_TEST(bob.deduction == 1.8);
  BOOST_TEST(bob.mark == 7.2);
  BOOST_TEST(bob.regraded == std::vector<std::string>{"square-values"},
             boost::test_tools::per_element());
  BOOST_TEST(marks.problems.empty());
}

BOOST_AUTO_TEST_CASE(open_and_refused_requests_change_nothing) {
  ClassMarks marks = toy_class::marks();
  const std::string open =
      "student = \"bob\"\ncheck = \"sum-order\"\nreason = \"why?\"\noutcome = \"open\"\n";

  const auto regrades = read({open, with("\"granted\"\npoints = 5", "\"refused\"")});
  apply_regrades(regrades, marks);

  BOOST_TEST(marks.students[1].mark->mark == toy_class::marks().students[1].mark->mark);
  BOOST_TEST(marks.students[1].mark->regraded.empty());
  BOOST_TEST(regrades_of(regrades, marks.students[1]).size() == 2U);
  BOOST_TEST(regrades_of(regrades, marks.students[0]).empty());
}

BOOST_AUTO_TEST_CASE(a_groups_request_is_that_of_all_its_members) {
  ClassMarks marks = toy_class::marks();
  marks.students[1].group = "g7";
  marks.students[2].group = "g7";
  const auto regrades = read({with("\"bob\"", "\"g7\"")});

  apply_regrades(regrades, marks);

  BOOST_TEST(marks.students[1].mark->checks.at("square-values") == 5);
  BOOST_TEST(marks.students[2].mark->checks.at("square-values") == 5);
  BOOST_TEST(regrades_of(regrades, marks.students[2]).size() == 1U);
}

BOOST_AUTO_TEST_CASE(a_request_of_somebody_without_a_mark_is_a_problem) {
  ClassMarks marks = toy_class::marks();

  apply_regrades(read({with("\"bob\"", "\"erin\"")}), marks);

  BOOST_REQUIRE(marks.problems.size() == 1U);
  BOOST_TEST(marks.problems[0].ends_with("0.toml:1:11: student: erin has no mark"));
}

BOOST_AUTO_TEST_CASE(a_request_that_is_wrong_is_told_with_its_place) {
  BOOST_TEST(message({with("square-values", "square-root")}) ==
             "0.toml:2:9: check: there is no check \"square-root\"");
  BOOST_TEST(message({with("points = 5", "points = 7")}) ==
             "0.toml:5:10: points: 7 is not from 0 to 6, the points of square-values");
  BOOST_TEST(message({with("\"granted\"", "\"yes\"")}) ==
             "0.toml:4:11: outcome: \"yes\" is not \"open\", \"granted\" or \"refused\"");
  BOOST_TEST(message({with("\"so they are\"", "\"\"")}) ==
             "0.toml:6:10: answer: must not be empty");
  BOOST_TEST(message({with("\"bob\"", "\".bob\"")}).starts_with("0.toml:1:11: student: "));
  BOOST_TEST(message({granted, granted}) ==
             "1.toml:1:11: student: bob has asked for square-values in another file already");
  BOOST_TEST(message({granted + "pionts = 3\n"}).starts_with("0.toml:8:"));
  // What is not decided yet has neither points nor an answer.
  BOOST_TEST(message({with("\"granted\"", "\"open\"")}).starts_with("0.toml:"));
  BOOST_CHECK_THROW(read_regrades(toy_grading::assignment(), "/nowhere"), sys::OutputError);
}

BOOST_AUTO_TEST_SUITE_END()
