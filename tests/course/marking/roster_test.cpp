// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/marking/roster.hpp"
#include "message_of.hpp"

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
  return message_of<sys::SourceError>([&] { read_roster(file); })
      .substr(folder.path().string().size() + 1);
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
               "class.csv:1:9: there is a column '" + column +
                   "'; the columns are student, name, submitted, deadline, slip_days and group");
  }
  BOOST_TEST(source_error("student,submitted, submitted\n") ==
             "class.csv:1:20: there are two columns 'submitted'");
}

BOOST_AUTO_TEST_CASE(a_class_that_is_wrong_is_told_with_its_line) {
  BOOST_TEST(source_error("") ==
             "class.csv:1:1: the class is empty; a header line with 'student' is wanted");
  BOOST_TEST(source_error("name\n") == "class.csv:1:1: there is no column 'student'");
  BOOST_TEST(source_error("student\na\na\n") == "class.csv:3:1: student a is listed twice");
  BOOST_TEST(source_error("student\na,b\n") ==
             "class.csv:2:1: the line has 2 fields, the first one has 1");
  BOOST_TEST(source_error("student,deadline\na\n") ==
             "class.csv:2:1: the line has 1 field, the first one has 2");
  BOOST_TEST(source_error("name,student\n\n\"Ada,a\n") == "class.csv:3:1: a quote is not closed");
  BOOST_TEST(source_error("student,student\n") == "class.csv:1:9: there are two columns 'student'");
  BOOST_TEST(
      source_error("student\n@a\n").starts_with("class.csv:2:1: student \"@a\": an id consists"));
  BOOST_TEST(source_error("student,deadline\na,noon\n") ==
             "class.csv:2:3: 'noon' is no time; write it as 2027-01-15T23:59:00+01:00");
  BOOST_TEST(source_error("student,submitted\na,noon\n") ==
             "class.csv:2:3: 'noon' is no time; write it as 2027-01-15T23:59:00+01:00");
}

BOOST_AUTO_TEST_CASE(a_class_may_have_quotes_blanks_and_a_byte_order_mark) {
  const TemporaryFolder folder;

  const Roster roster = read_roster(folder.write(
      "class.csv", "\xEF\xBB\xBF\"student\", name\n\n \"ada\" ,\"says \"\"no, never\"\"\"\nbob,"));

  BOOST_TEST(roster.size() == 2U);
  BOOST_TEST(roster.contains("ada"));
  BOOST_TEST(roster.contains("bob"));
}

BOOST_AUTO_TEST_CASE(slip_days_are_whole_numbers) {
  const TemporaryFolder folder;

  const Roster roster =
      read_roster(folder.write("class.csv", "student,slip_days\nalice,2\nbob,\n"));

  BOOST_TEST((roster.at("alice").slip_days == 2));
  BOOST_TEST(!roster.at("bob").slip_days.has_value());
  for (const std::string days : {"-1", "1.5", "two", "367"}) {
    BOOST_TEST(source_error("student,slip_days\na," + days + "\n") ==
               "class.csv:2:3: slip_days: '" + days + "' is no whole number from 0 to 366");
  }
}

BOOST_AUTO_TEST_CASE(a_group_is_one_unit_with_the_times_of_all_and_the_fewest_slip_days) {
  const TemporaryFolder folder;

  const Roster roster = read_roster(folder.write("class.csv",
                                                 "student,group,slip_days,submitted\n"
                                                 "alice,g7,3,2027-01-15T22:59:01Z\n"
                                                 "bob,,,\n"
                                                 "carol,g7,1,2027-01-15T22:59:01Z\n"
                                                 "dave,g7,,2027-01-15T23:59:01+01:00\n"));

  BOOST_TEST((units_of(roster) == std::vector<std::string>{"bob", "g7"}));
  BOOST_TEST((members_of(roster, "g7") == std::vector<std::string>{"alice", "carol", "dave"}));
  BOOST_TEST((members_of(roster, "bob") == std::vector<std::string>{"bob"}));
  BOOST_TEST(members_of(roster, "alice").empty());
  BOOST_TEST((entry_of(roster, "g7").slip_days == 1));
  BOOST_TEST((entry_of(roster, "g7").submitted == parse_time("2027-01-15T22:59:01Z")));
}

BOOST_AUTO_TEST_CASE(a_group_that_contradicts_itself_is_told_with_its_place) {
  BOOST_TEST(source_error("student,group,deadline\n"
                          "a,g7,2027-01-15T22:59:01Z\nb,g7,2027-01-16T22:59:01Z\n") ==
             "class.csv:3:6: members of group g7 differ in 'deadline'");
  BOOST_TEST(source_error("student,group\na,b\nb,\n") ==
             "class.csv:2:3: group b is named as a student is");
  BOOST_TEST(source_error("student,group\na,.b\n").starts_with("class.csv:2:3: student \".b\":"));
}

BOOST_AUTO_TEST_SUITE_END()
