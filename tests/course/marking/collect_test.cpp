// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/marking/collect.hpp"

#include <boost/test/unit_test.hpp>

#include "course/marking/mark.hpp"
#include "course/toy_grading.hpp"

BOOST_AUTO_TEST_SUITE(collect_test)

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
  folder.write("submissions/erin.zip", "");
  folder.write("submissions/zoe.zip", "");
  const Roster roster = {{"alice", {}}, {"bob", {}}, {"carol", {}}, {"erin", {}}};

  const Grades grades = collect_grades(toy_grading::assignment(), folder.path() / "grades", roster,
                                       folder.path() / "submissions");

  BOOST_TEST(grades.problems.empty());
  BOOST_TEST(grades.csv ==
             "student,state,points,deduction,mark,report,no file,not "
             "compiling,square-growth,square-values,"
             "sum-order,sum-values\r\n"
             "alice,missing,,,,,,,,,,\r\n"
             "bob,late,5.5,1.1,4.4,no,sum,square,4,1.5,0,0\r\n"
             "carol,on time,5.5,0,5.5,no,,,4,1.5,0,0\r\n"
             "erin,not graded,,,,,,,,,,\r\n"
             "zoe,not in the class,,,,,,,,,,\r\n");
}

BOOST_AUTO_TEST_CASE(a_mark_that_is_none_is_named_and_hinders_no_other) {
  const TemporaryFolder folder;
  write_mark(folder, graded("carol"));
  folder.write("grades/dave/mark.json", "{\"student\": \"dave\"}");
  folder.write("grades/mallory/mark.json", mark_json(toy_grading::assignment(), graded("carol")));

  const Grades grades = collect_grades(toy_grading::assignment(), folder.path() / "grades", {}, {});

  BOOST_TEST(grades.problems.size() == 2U);
  BOOST_TEST(grades.csv.find("\r\ncarol,") != std::string::npos);
  BOOST_TEST(grades.csv.find("dave") == std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
