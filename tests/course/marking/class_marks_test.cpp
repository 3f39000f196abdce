// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/marking/class_marks.hpp"

#include <fmt/core.h>

#include <boost/test/unit_test.hpp>

#include "course/marking/mark.hpp"
#include "course/toy_grading.hpp"
#include "holds.hpp"

BOOST_AUTO_TEST_SUITE(class_marks_test)

using namespace course;

namespace {

Graded graded(const std::string& student) {
  Graded one;
  one.student = student;
  one.results = {{"square-growth", 4, ""},
                 {"square-values", 1.5, ""},
                 {"sum-order", 0, ""},
                 {"sum-values", 0, ""}};
  return one;
}

void write_mark(const TemporaryFolder& folder, const Graded& one) {
  folder.write("grades/" + one.student + "/mark.json", mark_json(toy_grading::assignment(), one));
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_student_has_a_line_and_it_tells_what_happened) {
  const TemporaryFolder folder;
  write_mark(folder, graded("carol"));
  Graded bob = graded("bob");
  bob.late = {.days = 2, .percent = 20};
  bob.compile_errors = {{"sum", "x"}, {"square", "y"}};
  bob.submission.files = {{"src/square.cpp", "y"}};
  write_mark(folder, bob);
  write_mark(folder, graded("frank"));
  for (const char* name : {"bob", "carol", "erin"}) {
    folder.write(fmt::format("submissions/{}.zip", name), "");
  }
  folder.write("submissions/zoe.zip", "");
  const Roster roster = {{"alice", {}}, {"bob", {}}, {"carol", {}}, {"erin", {}}, {"frank", {}}};

  const ClassMarks marks = class_marks(toy_grading::assignment(), folder.path() / "grades", roster,
                                       folder.path() / "submissions");

  BOOST_REQUIRE(marks.problems.size() == 1U);
  BOOST_TEST(marks.problems[0].ends_with(
      "/frank' is left out, since nothing of this name was handed in: it is of an earlier run"));
  BOOST_TEST(marks_csv(toy_grading::assignment(), marks) ==
             "student,state,points,deduction,mark,report,no file,not "
             "compiling,slip days,group,square-growth,square-values,"
             "sum-order,sum-values\r\n"
             "alice,missing,,,,,,,,,,,,\r\n"
             "bob,late,5.5,1.1,4.4,no,sum,square,0,,4,1.5,0,0\r\n"
             "carol,on time,5.5,0,5.5,no,,,0,,4,1.5,0,0\r\n"
             "erin,not graded,,,,,,,,,,,,\r\n"
             "frank,missing,,,,,,,,,,,,\r\n"
             "zoe,not in the class,,,,,,,,,,,,\r\n");
}

BOOST_AUTO_TEST_CASE(each_member_of_a_group_has_its_mark) {
  const TemporaryFolder folder;
  write_mark(folder, graded("g7"));
  const Roster roster = {
      {"alice", {.group = "g7"}}, {"bob", {.group = "g7"}}, {"carol", {.group = "g8"}}};

  const ClassMarks marks =
      class_marks(toy_grading::assignment(), folder.path() / "grades", roster, {});

  BOOST_REQUIRE(marks.students.size() == 3U);
  BOOST_TEST(marks.students[0].student == "alice");
  BOOST_TEST(marks.students[0].unit() == "g7");
  BOOST_TEST(marks.students[1].mark->points == 5.5);
  BOOST_TEST(marks.students[2].state == "missing");
  BOOST_TEST(holds(marks_csv(toy_grading::assignment(), marks),
                   "\r\nbob,on time,5.5,0,5.5,no,,,0,g7,4,1.5,0,0\r\n"));
}

BOOST_AUTO_TEST_CASE(a_file_that_cannot_be_graded_is_not_missing) {
  const TemporaryFolder folder;
  write_mark(folder, graded("g7"));
  folder.write("submissions/carol.rar", "");
  folder.write("submissions/alice/src/square.cpp", "");
  folder.write("submissions/g7.zip", "");
  folder.write("submissions/.listing", "");
  const Roster roster = {{"alice", {.group = "g7"}}, {"carol", {}}, {"dave", {}}};

  const ClassMarks marks = class_marks(toy_grading::assignment(), folder.path() / "grades", roster,
                                       folder.path() / "submissions");

  BOOST_REQUIRE(marks.students.size() == 3U);
  BOOST_TEST(marks.students[0].student == "alice");
  BOOST_TEST(marks.students[0].mark->points == 5.5);
  BOOST_TEST(marks.students[1].state == "not graded");
  BOOST_TEST(marks.students[2].state == "missing");
}

BOOST_AUTO_TEST_CASE(a_mark_that_is_none_is_named_and_hinders_no_other) {
  const TemporaryFolder folder;
  write_mark(folder, graded("carol"));
  folder.write("grades/dave/mark.json", "{\"student\": \"dave\"}");
  folder.write("grades/mallory/mark.json", mark_json(toy_grading::assignment(), graded("carol")));

  const ClassMarks marks = class_marks(toy_grading::assignment(), folder.path() / "grades", {}, {});

  BOOST_TEST(marks.problems.size() == 2U);
  BOOST_TEST(marks.students.size() == 1U);
  BOOST_TEST(marks.students.front().student == "carol");
}

BOOST_AUTO_TEST_SUITE_END()
