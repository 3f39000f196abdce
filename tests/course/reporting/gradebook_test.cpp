// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/reporting/gradebook.hpp"

#include <boost/test/unit_test.hpp>

#include "course/toy_grading.hpp"
#include "holds.hpp"
#include "message_of.hpp"
#include "system/error.hpp"

BOOST_AUTO_TEST_SUITE(gradebook_test)

using namespace course;

namespace {

const std::string head =
    "Student,ID,SIS User ID,SIS Login ID,Section,Toy (4711),Exam (12),Current Score\n";

/// A student of the toy with these points of its checks, in their order.
StudentMark student(const std::string& id, const std::vector<double>& points, double percent = 0) {
  const std::vector<std::string> checks = check_ids(toy_grading::assignment());
  Mark mark;
  for (std::size_t i = 0; i < checks.size(); ++i) {
    mark.checks[checks[i]] = points[i];
    mark.points += points[i];
  }
  mark.deduction = mark.points * percent / 100;
  mark.mark = mark.points - mark.deduction;
  return {.student = id, .state = percent > 0 ? "late" : "on time", .mark = mark};
}

/// Four students, of whom one is late, and a fifth who handed in nothing.
const ClassMarks marks = {.students = {student("alice", {4, 6, 5, 5}),
                                       student("bob", {4, 1.5, 0, 0}, 20),
                                       student("carol", {4, 6, 0, 2.5}),
                                       student("dave", {0, 0, 5, 0}),
                                       {.student = "erin", .state = "missing"}},
                          .problems = {}};

FilledGradebook filled(const std::string& text, const std::string& column = "") {
  return canvas_csv(toy_grading::assignment(), marks, text, "canvas.csv", column);
}

std::string message(const std::string& text, const std::string& column = "") {
  return message_of<sys::SourceError>([&] { filled(text, column); });
}

}  // namespace

BOOST_AUTO_TEST_CASE(moodle_gets_who_has_a_mark_and_the_points_of_each_exercise) {
  BOOST_TEST(moodle_csv(toy_grading::assignment(), marks) ==
             "student,grade,feedback\r\n"
             "alice,20,Squares: 10 of 10. Sums: 10 of 10.\r\n"
             "bob,4.4,Squares: 5.5 of 10. Sums: 0 of 10. Deducted for lateness: 1.1.\r\n"
             "carol,12.5,Squares: 10 of 10. Sums: 2.5 of 10.\r\n"
             "dave,5,Squares: 0 of 10. Sums: 5 of 10.\r\n");
}

BOOST_AUTO_TEST_CASE(canvas_gets_its_own_lines_back_with_the_marks) {
  const FilledGradebook gradebook = filled(head +
                                           "    Points Possible,,,,,20,90,(read only)\n"
                                           "\"Adams, Alice\",7,,alice,S1,,88,97\n"
                                           "Bob,8,bob,,S1,3,,\n"
                                           "Erin,9,,erin,S2,,,\n"
                                           "Carol,10,,carol,S2,,,\n"
                                           "Dave,11,dave,dave.d,S2,,,\n");

  BOOST_TEST(gradebook.csv ==
             "Student,ID,SIS User ID,SIS Login ID,Section,Toy (4711)\r\n"
             "\"Adams, Alice\",7,,alice,S1,20\r\n"
             "Bob,8,bob,,S1,4.4\r\n"
             "Erin,9,,erin,S2,\r\n"
             "Carol,10,,carol,S2,12.5\r\n"
             "Dave,11,dave,dave.d,S2,5\r\n");
  BOOST_TEST(gradebook.problems.empty());
  BOOST_REQUIRE(filled(head + "Bob,8,bob,,S1,,,\n").problems.size() == 3U);
  BOOST_TEST(filled(head + "Bob,8,bob,,S1,,,\n").problems[2] ==
             "canvas.csv: there is no line for student dave, whose mark is 5");
}

BOOST_AUTO_TEST_CASE(the_column_of_the_marks_may_be_named) {
  BOOST_TEST(filled(head + "Alice,7,,alice,S1,,88,97\n", "Exam (12)").csv ==
             "Student,ID,SIS User ID,SIS Login ID,Section,Exam (12)\r\nAlice,7,,alice,S1,20\r\n");
}

BOOST_AUTO_TEST_CASE(what_is_no_gradebook_of_canvas_is_refused) {
  BOOST_TEST(message("") == "canvas.csv:1:1: the gradebook is empty");
  BOOST_TEST(holds(message("student,mark\n"), "there is no column 'Student'"));
  BOOST_TEST(message("Student,ID,Section,Exam (12)\n") ==
             "canvas.csv:1:1: there are 0 columns that begin with 'Toy (', not one; COLUMN='name' "
             "says which");
  BOOST_TEST(message(head, "Toy") ==
             "canvas.csv:1:1: there are 0 columns named 'Toy', not one; COLUMN='name' says which");
  BOOST_TEST(message(head + "Alice,7\n") ==
             "canvas.csv:2:1: the line has 2 fields, the first one has 8");
}

BOOST_AUTO_TEST_SUITE_END()
