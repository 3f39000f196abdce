// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/marking/collect.hpp"

#include <boost/test/unit_test.hpp>

#include "course/marking/csv.hpp"
#include "course/marking/mark.hpp"
#include "system/error.hpp"
#include "toy_grading.hpp"

using namespace course;
namespace fs = std::filesystem;
using boost::test_tools::per_element;

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
  folder.write("grades/" + one.student + "/mark.json", mark_json(toy::assignment(), one));
}

std::string source_error(const std::string& roster) {
  const TemporaryFolder folder;
  const fs::path file = folder.write("class.csv", roster);
  try {
    read_roster(file);
  } catch (const sys::SourceError& error) {
    return std::string(error.what()).substr(folder.path().string().size() + 1);
  }
  return "";
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

  const Grades grades = collect_grades(toy::assignment(), folder.path() / "grades", roster,
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
  folder.write("grades/mallory/mark.json", mark_json(toy::assignment(), graded("carol")));

  const Grades grades = collect_grades(toy::assignment(), folder.path() / "grades", {}, {});

  BOOST_TEST(grades.problems.size() == 2U);
  BOOST_TEST(grades.csv.find("\r\ncarol,") != std::string::npos);
  BOOST_TEST(grades.csv.find("dave") == std::string::npos);
}

BOOST_AUTO_TEST_CASE(fields_are_quoted_and_are_no_formulas) {
  BOOST_TEST(csv_field("plain") == "plain");
  BOOST_TEST(csv_field("a,\"b\"") == "\"a,\"\"b\"\"\"");
  BOOST_TEST(csv_field("=1+1") == "'=1+1");
  BOOST_TEST(csv_field("@cmd,x") == "\"'@cmd,x\"");
  BOOST_TEST(csv_fields("a,\"b,\"\"c\"\"\",") == (std::vector<std::string>{"a", "b,\"c\"", ""}),
             per_element());
  BOOST_CHECK_THROW(csv_fields("\"open"), sys::SourceError);
  BOOST_CHECK_THROW(csv_fields("\"a\"b"), sys::SourceError);
}

BOOST_AUTO_TEST_CASE(the_class_is_read_with_its_times) {
  const TemporaryFolder folder;

  const Roster roster = read_roster(
      folder.write("class.csv",
                   "name,student,submitted,deadline\r\n\"A, B\",alice,2027-01-15T23:59:01+01:00,\n"
                   "C,carol,,2027-01-20T12:00:00Z\n"));

  BOOST_TEST(roster.size() == 2U);
  BOOST_TEST((roster.at("alice").submitted == parse_time("2027-01-15T22:59:01Z")));
  BOOST_TEST(!roster.at("alice").deadline.has_value());
  BOOST_TEST(!roster.at("carol").submitted.has_value());
  BOOST_TEST((roster.at("carol").deadline == parse_time("2027-01-20T12:00:00Z")));
}

BOOST_AUTO_TEST_CASE(a_class_that_is_wrong_is_told_with_its_line) {
  BOOST_TEST(source_error("") ==
             "class.csv:1: the class is empty; a header line with 'student' is wanted");
  BOOST_TEST(source_error("name\n") == "class.csv:1: there is no column 'student'");
  BOOST_TEST(source_error("student\na\na\n") == "class.csv:3: student a is listed twice");
  BOOST_TEST(source_error("student\na,b\n") == "class.csv:2: 2 fields; the header has 1");
  BOOST_TEST(source_error("student\n@a\n").starts_with("class.csv:2: student \"@a\": an id is"));
  BOOST_TEST(source_error("student,deadline\na,noon\n") ==
             "class.csv:2: 'noon' is no time; write it as 2027-01-15T23:59:00+01:00");
  BOOST_TEST(source_error("student,submitted\na,noon\n") ==
             "class.csv:2: 'noon' is no time; write it as 2027-01-15T23:59:00+01:00");
}

BOOST_AUTO_TEST_CASE(what_is_to_be_graded_is_listed_and_the_rest_told) {
  const TemporaryFolder folder;
  folder.write("alice/src/square.cpp", "");
  folder.write("alice.zip", "");
  folder.write("bob.tar.gz", "");
  folder.write("zoe.zip", "");
  folder.write("line\nend.zip", "");
  folder.write("notes.txt", "");
  folder.write(".DS_Store", "");
  fs::create_symlink("/etc", folder.path() / "mallory");

  const Listing listing =
      list_submissions(folder.path(), Roster{{"alice", {}}, {"bob", {}}, {"mallory", {}}});

  BOOST_REQUIRE(listing.entries.size() == 1U);
  BOOST_TEST(listing.entries[0].student == "bob");
  BOOST_REQUIRE(listing.problems.size() == 5U);
  BOOST_TEST(listing.problems[0].starts_with("'line?end.zip' is not named for a student: "));
  BOOST_TEST(listing.problems[1].starts_with("'mallory' is neither a folder nor an archive"));
  BOOST_TEST(listing.problems[3] == "'zoe.zip': there is no student zoe in the class");
  BOOST_TEST(listing.problems[4] ==
             "student alice has more than one submission: 'alice' and 'alice.zip'");
}

BOOST_AUTO_TEST_CASE(what_is_no_folder_of_submissions_is_an_error) {
  const TemporaryFolder folder;

  BOOST_CHECK_THROW(list_submissions(folder.write("class.csv", ""), {}), sys::OutputError);
  BOOST_CHECK_THROW(list_submissions(folder.path() / "nowhere", {}), sys::OutputError);
}

BOOST_AUTO_TEST_CASE(a_day_begun_is_a_day) {
  const Assignment assignment = toy::assignment();
  const auto after = [&](std::chrono::seconds time) {
    return lateness(assignment, assignment.deadline + time);
  };
  using std::chrono::days;
  using std::chrono::seconds;

  BOOST_TEST(lateness(assignment, {}).days == 0);
  BOOST_TEST(after(seconds(0)).percent == 0);
  BOOST_TEST(after(seconds(1)).percent == 10);
  BOOST_TEST(after(days(1)).days == 1);
  BOOST_TEST(after(days(5)).percent == 50);
  BOOST_TEST(!after(days(5)).is_refused);
  BOOST_TEST(after(days(5) + seconds(1)).percent == 100);
  BOOST_TEST(after(days(5) + seconds(1)).is_refused);
}

BOOST_AUTO_TEST_CASE(times_are_those_of_rfc_3339) {
  BOOST_TEST((parse_time("2026-12-31T23:30:00-01:00") == parse_time("2027-01-01T00:30:00.25Z")));
  for (const char* text : {"", "2027-01-15", "2027-01-15T23:59:00", "2027-02-29T00:00:00Z",
                           "2027-01-15T24:00:00Z", "2027-01-15T23:59:00+1:00"}) {
    BOOST_CHECK_THROW(parse_time(text), sys::SourceError);
  }
}
