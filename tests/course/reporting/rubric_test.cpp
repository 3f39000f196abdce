// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/reporting/rubric.hpp"

#include <boost/test/unit_test.hpp>

#include "course/marking/collect.hpp"
#include "course/reporting/feedback_release.hpp"
#include "course/reporting/gradebook.hpp"
#include "course/reporting/statistics.hpp"
#include "course/reporting/toy_class.hpp"
#include "message_of.hpp"
#include "system/error.hpp"

BOOST_AUTO_TEST_SUITE(rubric_test)

using namespace course;

namespace {

Assignment assignment() {
  Assignment toy = toy_grading::assignment();
  toy.criteria = {{.id = "words", .title = "Words", .says = "is it said?", .points = 4},
                  {.id = "figures", .title = "Figures", .says = "axes, units", .points = 6}};
  return toy;
}

/// Alice and Bob handed in a report, Carol and Dave did not.
ClassMarks marks() {
  ClassMarks marks = toy_class::marks();
  marks.students[0].mark->has_report = true;
  marks.students[1].mark->has_report = true;
  return marks;
}

const std::string header = "student,criterion,points,comment,marker\n";

std::vector<RubricLine> read(const std::string& lines,
                             const std::map<std::string, std::string>& names = {}) {
  const TemporaryFolder folder;
  return read_rubric_lines(assignment(), folder.write("marks.csv", header + lines), names);
}

std::string message(const std::string& text) {
  const TemporaryFolder folder;
  const std::string what = message_of<sys::SourceError>(
      [&] { read_rubric_lines(assignment(), folder.write("marks.csv", text), {}); });
  return what.substr(what.rfind('/') + 1);
}

const std::string all_marked =
    "alice,words,4,,mallory\nalice,figures,4.5,\"no units, no axes\",mallory\n"
    "bob,words,0,,mallory\nbob,figures,6,,mallory\n";

}  // namespace

BOOST_AUTO_TEST_CASE(points_of_the_report_count_and_are_deducted_as_the_others) {
  ClassMarks all = marks();

  apply_rubric(assignment(), read(all_marked), all);

  BOOST_TEST(all.problems.empty());
  BOOST_TEST(all.most == 30);
  BOOST_TEST(all.students[0].mark->mark == 28.5);
  BOOST_TEST(all.students[1].mark->points == 11.5);
  BOOST_TEST(all.students[1].mark->deduction == 2.3);
  BOOST_TEST(all.students[1].mark->mark == 9.2);
  BOOST_TEST(all.students[2].mark->mark == 12.5);
}

BOOST_AUTO_TEST_CASE(they_are_in_the_table_the_gradebook_and_the_feedback) {
  ClassMarks all = marks();
  apply_rubric(assignment(), read(all_marked), all);

  const std::string csv = marks_csv(assignment(), all);
  BOOST_TEST(csv.find(",sum-values,words,figures\r\n") != std::string::npos);
  BOOST_TEST(csv.find("alice,on time,28.5,0,28.5,yes,,,0,,,4,6,5,5,4,4.5\r\n") !=
             std::string::npos);
  BOOST_TEST(csv.find("erin,missing,,,,,,,,,,,,,,,\r\n") != std::string::npos);
  BOOST_TEST(moodle_csv(assignment(), all).find("Words: 4 of 4. Figures: 4.5 of 6.") !=
             std::string::npos);
  const std::string page = final_feedback(
      assignment(), "<html><body><p id=\"mark\"/></body></html>", all.most, all.students[0], {});
  BOOST_TEST(page.find("alice: 28.5 of 30 points") != std::string::npos);
  BOOST_TEST(page.find("<div>Figures: axes, units</div>"
                       "<div class=\"note\">no units, no axes</div></td><td>4.5 / 6</td>") !=
             std::string::npos);
  BOOST_TEST(page.find("mallory") == std::string::npos);  // who marked is not told
}

BOOST_AUTO_TEST_CASE(the_statistics_of_checks_are_those_without_the_report) {
  ClassMarks all = marks();
  apply_rubric(assignment(), read(all_marked), all);

  const ClassStatistics with = statistics_of(assignment(), all);
  const ClassStatistics without = statistics_of(assignment(), marks());

  BOOST_TEST(with.items[1].discrimination.value() == without.items[1].discrimination.value());
  BOOST_TEST(with.most == 28.5);
  BOOST_TEST(with.histogram[9] == 1U);
}

BOOST_AUTO_TEST_CASE(a_group_has_the_points_of_its_report) {
  ClassMarks all = marks();
  all.students[0].group = "g7";
  all.students[1].group = "g7";

  apply_rubric(assignment(), read("g7,words,3,,br\ng7,figures,2,,br\n"), all);

  BOOST_TEST(all.problems.empty());
  BOOST_TEST(all.students[0].mark->points == 25);
  BOOST_TEST(all.students[1].mark->points == 10.5);
}

BOOST_AUTO_TEST_CASE(what_is_not_marked_is_told) {
  ClassMarks all = marks();

  apply_rubric(assignment(), read("alice,words,4,,br\nalice,figures,,,\nzoe,words,1,,br\n"), all);

  BOOST_REQUIRE(all.problems.size() == 3U);
  BOOST_TEST(all.problems[0].ends_with("marks.csv:4:1: student: zoe has no mark"));
  BOOST_TEST(all.problems[1] == "the report of alice is not marked: figures");
  BOOST_TEST(all.problems[2] == "the report of bob is not marked: words, figures");
}

BOOST_AUTO_TEST_CASE(drawn_names_without_the_seed_are_told_once) {
  const auto names = anonymous_names({"alice", "bob"}, "autumn 27");
  const std::string lines =
      names.at("alice") + ",words,4,,br\n" + names.at("bob") + ",words,3,,br\nzoe,words,1,,br\n";
  ClassMarks all = marks();

  apply_rubric(assignment(), read(lines), all);

  BOOST_REQUIRE(all.problems.size() == 2U);
  BOOST_TEST(all.problems[0].ends_with(
      "marks.csv:2:1: student: these names are drawn from the seed: give SEED_FILE=file "
      "(--seed-file)"));
  BOOST_TEST(all.problems[1].ends_with("marks.csv:4:1: student: zoe has no mark"));
  all = marks();
  apply_rubric(assignment(), read(lines, anonymous_names({"alice"}, "autumn 28")), all);
  BOOST_TEST(all.problems[0].ends_with(names.at("alice") + " has no mark"));
}

BOOST_AUTO_TEST_CASE(a_rubric_without_the_markers_file_is_told) {
  BOOST_TEST(without_markers_file(toy_grading::assignment()).empty());
  BOOST_TEST(
      without_markers_file(assignment()) ==
      "the rubric has criteria worth 10 points for the report, and MARKS=file (--marks), which "
      "says what each report has of them, is missing");
}

BOOST_AUTO_TEST_CASE(names_of_reports_do_not_tell_the_student_and_stand_for_them) {
  const auto names = anonymous_names({"alice", "bob"}, "autumn 27");

  BOOST_TEST(names.at("alice").starts_with("report-"));
  BOOST_TEST(names.at("alice").size() == 17U);
  BOOST_TEST(names.at("alice") != names.at("bob"));
  BOOST_TEST(names.at("alice") != anonymous_names({"alice"}, "autumn 28").at("alice"));
  const auto lines = read(names.at("bob") + ",words,3,,br\nalice,words,1,,br\n", names);
  BOOST_REQUIRE(lines.size() == 2U);
  BOOST_TEST(lines[0].unit == "bob");
  BOOST_TEST(lines[1].unit == "alice");
}

BOOST_AUTO_TEST_CASE(the_form_is_a_file_in_which_nothing_is_marked) {
  const std::string form = rubric_form(assignment(), {"report-1", "report-2"});

  BOOST_TEST(form == header.substr(0, header.size() - 1) +
                         "\r\nreport-1,words,,,\r\nreport-1,figures,,,\r\n"
                         "report-2,words,,,\r\nreport-2,figures,,,\r\n");
  BOOST_TEST(read(form.substr(form.find('\n') + 1)).empty());
}

BOOST_AUTO_TEST_CASE(a_line_that_is_wrong_is_told_with_its_place) {
  BOOST_TEST(message("") == "marks.csv:1:1: there is no header line");
  BOOST_TEST(message("student,criterion,points,comment\n") ==
             "marks.csv:1:1: there is no column 'marker'");
  BOOST_TEST(message("student,mark\n") ==
             "marks.csv:1:9: there is a column 'mark'; the columns are student, criterion, points, "
             "comment and marker, each once");
  BOOST_TEST(message(header + "alice,word,1,,br\n") ==
             "marks.csv:2:7: there is no criterion 'word'");
  for (const std::string points : {"4.5", "-1", "nan", "two"}) {
    BOOST_TEST(message(header + "alice,words," + points + ",,br\n") ==
               "marks.csv:2:13: points: '" + points +
                   "' is no number from 0 to 4, the points of words");
  }
  BOOST_TEST(message(header + "alice,words,4,,\n") ==
             "marks.csv:2:16: marker: it is not said who gave the points");
  BOOST_TEST(message(header + "alice,words,4,,br\nalice,words,,,\n") ==
             "marks.csv:3:1: there is a line for alice and words already");
}

BOOST_AUTO_TEST_SUITE_END()
