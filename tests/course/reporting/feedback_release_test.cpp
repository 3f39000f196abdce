// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/reporting/feedback_release.hpp"

#include <boost/test/unit_test.hpp>

#include "course/marking/feedback.hpp"
#include "course/reporting/toy_class.hpp"
#include "message_of.hpp"
#include "system/error.hpp"
#include "system/files.hpp"

BOOST_AUTO_TEST_SUITE(feedback_release_test)

using namespace course;

namespace {

/// The page that grading wrote for Bob, who was a day late.
std::string page() {
  Graded graded;
  graded.student = "bob";
  graded.late = {.days = 2, .percent = 20};
  graded.results = {{"square-growth", 4, ""},
                    {"square-values", 1.5, "hidden message"},
                    {"sum-order", 0, "is no\n  sum"},
                    {"sum-values", 0, ""}};
  graded.submission.has_report = true;
  graded.compile_errors = {{"sum", "  error:\n\n  a < b && c"}};
  return feedback_html(toy_grading::assignment(), graded, {"<svg><text>  x </text></svg>"});
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

Regrade regrade(RegradeOutcome outcome) {
  return {.student = "bob",
          .check = "square-values",
          .reason = "a < b",
          .outcome = outcome,
          .points = 5,
          .answer = "So it is.",
          .marker = "br",
          .place = {}};
}

std::string final_page(const std::vector<Regrade>& regrades) {
  ClassMarks marks = toy_class::marks();
  apply_regrades(regrades, marks);
  return final_feedback(toy_grading::assignment(), page(), marks.most, marks.students[1], regrades);
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_page_without_requests_says_what_it_said) {
  const std::string released = final_page({});

  BOOST_TEST(has(page(), "bob: 4.4 of 20 points"));
  BOOST_TEST(has(released, "bob: 4.4 of 20 points (reached 5.5, deducted 1.1)"));
  BOOST_TEST(!has(released, "Reached 5.5, deducted 1.1."));
  BOOST_TEST(has(released, "<pre>  error:\n\n  a &lt; b &amp;&amp; c</pre>"));
  BOOST_TEST(has(released, "<text>  x </text>"));
  BOOST_TEST(released.starts_with("<!DOCTYPE html>"));
  BOOST_TEST(!has(released, "Marked again"));
}

BOOST_AUTO_TEST_CASE(a_decision_is_told_with_its_reason_and_changes_the_mark) {
  const std::string granted = final_page({regrade(RegradeOutcome::granted)});

  BOOST_TEST(has(granted, "bob: 7.2 of 20 points (reached 9, deducted 1.8)"));
  BOOST_TEST(has(granted, "Squares: squares at points of your own"));
  BOOST_TEST(has(granted, "You wrote: a &lt; b"));
  BOOST_TEST(has(granted, "It now gives 5 points. So it is. (br)"));
  BOOST_TEST(
      has(final_page({regrade(RegradeOutcome::refused)}), "It stays as it is. So it is. (br)"));
  BOOST_TEST(has(final_page({regrade(RegradeOutcome::open)}), "It is not decided yet."));
}

BOOST_AUTO_TEST_CASE(the_row_of_a_check_that_was_marked_again_has_its_new_points) {
  const std::string before = "<div class=\"note\">hidden check</div>";
  BOOST_REQUIRE(has(page(), before + "</td><td>1.5 / 6</td>"));

  const std::string granted = final_page({regrade(RegradeOutcome::granted)});

  const std::string again = before + "<div class=\"note\">marked again</div></td>";
  BOOST_TEST(has(granted, again + "<td>5 / 6</td>"));
  BOOST_TEST(!has(granted, "1.5 / 6"));
  BOOST_TEST(!has(granted, "square-values"));  // the id of a hidden check
  Regrade in_full = regrade(RegradeOutcome::granted);
  in_full.points = 6;
  BOOST_TEST(has(final_page({in_full}),
                 "<tr><td><div>squares at points of your own</div>" + again + "<td>6 / 6</td>"));
  BOOST_TEST(has(final_page({regrade(RegradeOutcome::refused)}), before + "</td><td>1.5 / 6</td>"));
}

BOOST_AUTO_TEST_CASE(a_page_without_the_row_of_a_check_is_refused) {
  ClassMarks marks = toy_class::marks();
  const std::vector<Regrade> regrades = {regrade(RegradeOutcome::granted)};
  apply_regrades(regrades, marks);

  const std::string message = message_of<sys::OutputError>([&] {
    final_feedback(toy_grading::assignment(), "<html><body><p id=\"mark\"/></body></html>",
                   marks.most, marks.students[1], regrades);
  });

  BOOST_TEST(message == "there is no row of square-values");
}

BOOST_AUTO_TEST_CASE(the_report_is_said_to_be_marked_until_its_points_are_there) {
  BOOST_TEST(has(page(), "The report is marked by a person."));
  BOOST_TEST(has(final_page({}), "The report is marked by a person."));
  Assignment assignment = toy_grading::assignment();
  assignment.criteria = {{.id = "words", .title = "Words", .says = "is it said?", .points = 4}};
  ClassMarks marks = toy_class::marks();
  marks.students[1].mark->criteria["words"] = {.points = 3, .comment = {}, .marker = "br"};

  const std::string marked = final_feedback(assignment, page(), 24, marks.students[1], {});

  BOOST_TEST(!has(marked, "is marked by a person"));
  BOOST_TEST(has(marked, "<td>3 / 4</td>"));
}

BOOST_AUTO_TEST_CASE(students_get_their_pages_and_nothing_else) {
  const TemporaryFolder folder;
  ClassMarks marks = toy_class::marks();
  marks.students = {marks.students[0], marks.students[1], marks.students[4]};
  marks.students[1].group = "g7";
  folder.write("grades/alice/feedback.html", page());
  folder.write("grades/g7/feedback.html", page());
  folder.write("grades/g7/log.txt", "secret");
  folder.write("feedback/zoe.html", "of last time");

  release_feedback(toy_grading::assignment(), folder.path() / "grades", marks, {},
                   folder.path() / "feedback");

  BOOST_TEST(sys::files_below(folder.path() / "feedback") ==
                 (std::vector<std::string>{"alice.html", "bob.html"}),
             boost::test_tools::per_element());
  BOOST_TEST(has(sys::read_file(folder.path() / "feedback/bob.html"), "bob: 4.4 of 20"));
}

BOOST_AUTO_TEST_CASE(a_page_that_is_none_is_named_and_the_old_ones_stay) {
  const TemporaryFolder folder;
  ClassMarks marks = toy_class::marks();
  marks.students = {marks.students[0]};
  folder.write("grades/alice/feedback.html", "<html><body/></html>");
  folder.write("feedback/alice.html", "of last time");

  const std::string message = message_of<sys::OutputError>([&] {
    release_feedback(toy_grading::assignment(), folder.path() / "grades", marks, {},
                     folder.path() / "feedback");
  });

  BOOST_TEST(message.ends_with("alice/feedback.html': it is no feedback that `grade` wrote"));
  BOOST_TEST(sys::read_file(folder.path() / "feedback/alice.html") == "of last time");
}

BOOST_AUTO_TEST_CASE(what_is_not_graded_keeps_all_feedback_back) {
  ClassMarks marks = toy_class::marks();
  BOOST_TEST(reasons_to_wait(marks).empty());
  marks.students[4].state = "not graded";
  marks.problems = {"'x' is no mark of this assignment"};

  const auto reasons = reasons_to_wait(marks);

  BOOST_REQUIRE(reasons.size() == 2U);
  BOOST_TEST(reasons[1] == "student erin handed something in that is not graded");
}

BOOST_AUTO_TEST_SUITE_END()
