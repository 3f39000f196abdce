// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/marking/roster.hpp"

#include <boost/test/unit_test.hpp>
#include <string>

#include "system/error.hpp"
#include "temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(roster_test)

using namespace course;
namespace fs = std::filesystem;

namespace {

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

BOOST_AUTO_TEST_CASE(blanks_around_a_heading_do_not_switch_lateness_off) {
  const TemporaryFolder folder;

  const Roster roster = read_roster(
      folder.write("class.csv", "student, submitted\t\nalice, 2027-01-15T22:59:01Z \nbob,\n"));

  BOOST_TEST((roster.at("alice").submitted == parse_time("2027-01-15T22:59:01Z")));
  BOOST_TEST(lateness_source(roster) == "lateness from column 'submitted': 1 of 2 students");
  BOOST_TEST(lateness_source({{"alice", {}}}) ==
             "the class has no time in a column 'submitted': nobody is late");
}

BOOST_AUTO_TEST_CASE(a_column_that_nobody_reads_is_refused) {
  for (const std::string column : {"Submitted", "submited", "late"}) {
    BOOST_TEST(source_error("student," + column + "\nalice,2027-01-15T22:59:01Z\n") ==
               "class.csv:1: there is a column '" + column +
                   "'; the columns are student, name, submitted and deadline");
  }
  BOOST_TEST(source_error("student,submitted, submitted\n") ==
             "class.csv:1: there are two columns 'submitted'");
}

BOOST_AUTO_TEST_CASE(a_class_that_is_wrong_is_told_with_its_line) {
  BOOST_TEST(source_error("") ==
             "class.csv:1: the class is empty; a header line with 'student' is wanted");
  BOOST_TEST(source_error("name\n") == "class.csv:1: there is no column 'student'");
  BOOST_TEST(source_error("student\na\na\n") == "class.csv:3: student a is listed twice");
  BOOST_TEST(source_error("student\na,b\n") ==
             "class.csv:2: there are more fields than the header has");
  BOOST_TEST(source_error("student,deadline\na\n") ==
             "class.csv:2: there are fewer fields than the header has");
  BOOST_TEST(source_error("name,student\n\n\"Ada,a\n") == "class.csv:3: a quote is not closed");
  BOOST_TEST(source_error("student,student\n") == "class.csv:1: there are two columns 'student'");
  BOOST_TEST(
      source_error("student\n@a\n").starts_with("class.csv:2: student \"@a\": an id consists"));
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

BOOST_AUTO_TEST_CASE(a_class_may_have_quotes_blanks_and_a_byte_order_mark) {
  const TemporaryFolder folder;

  const Roster roster = read_roster(folder.write(
      "class.csv", "\xEF\xBB\xBF\"student\", name\n\n \"ada\" ,\"says \"\"no, never\"\"\"\nbob,"));

  BOOST_TEST(roster.size() == 2U);
  BOOST_TEST(roster.contains("ada"));
  BOOST_TEST(roster.contains("bob"));
}

BOOST_AUTO_TEST_CASE(what_is_no_folder_of_submissions_is_an_error) {
  const TemporaryFolder folder;

  BOOST_CHECK_THROW(list_submissions(folder.write("class.csv", ""), {}), sys::OutputError);
  BOOST_CHECK_THROW(list_submissions(folder.path() / "nowhere", {}), sys::OutputError);
}

BOOST_AUTO_TEST_SUITE_END()
