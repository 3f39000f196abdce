// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/marking/lateness.hpp"

#include <boost/test/unit_test.hpp>

#include "course/marking/mark.hpp"
#include "course/toy_grading.hpp"
#include "system/error.hpp"

BOOST_AUTO_TEST_SUITE(lateness_test)

using namespace course;

BOOST_AUTO_TEST_CASE(a_day_begun_is_a_day) {
  const Assignment assignment = toy_grading::assignment();
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

BOOST_AUTO_TEST_CASE(minutes_of_grace_are_granted_each_day) {
  Assignment assignment = toy_grading::assignment();
  assignment.late.grace_minutes = 15;
  const auto days_after = [&](std::chrono::seconds time) {
    return lateness(assignment, assignment.deadline + time).days;
  };
  using std::chrono::days;
  using std::chrono::minutes;
  using std::chrono::seconds;

  BOOST_TEST(days_after(minutes(15)) == 0);
  BOOST_TEST(days_after(minutes(15) + seconds(1)) == 1);
  BOOST_TEST(days_after(days(1) + minutes(15)) == 1);
  BOOST_TEST(days_after(days(1) + minutes(15) + seconds(1)) == 2);
}

BOOST_AUTO_TEST_CASE(slip_days_cost_nothing_as_long_as_there_are_some) {
  Assignment assignment = toy_grading::assignment();
  assignment.late = {.percent_per_day = 10, .days = 1, .slip_days = 3};
  const auto after = [&](int days, std::optional<int> left) {
    return lateness(assignment, assignment.deadline + std::chrono::days(days), left);
  };

  BOOST_TEST(after(2, {}).slip_days == 2);
  BOOST_TEST(after(2, {}).percent == 0);
  BOOST_TEST(after(4, {}).slip_days == 3);
  BOOST_TEST(after(4, {}).percent == 10);
  BOOST_TEST(after(2, 1).slip_days == 1);
  BOOST_TEST(after(2, 1).percent == 10);
  BOOST_TEST(after(2, 9).slip_days == 2);
  BOOST_TEST(after(3, 1).is_refused);
  BOOST_TEST(after(3, 1).slip_days == 0);
}

BOOST_AUTO_TEST_CASE(a_last_time_takes_the_place_of_the_days) {
  Assignment assignment = toy_grading::assignment();
  assignment.late.until = assignment.deadline + std::chrono::days(7);
  const auto after = [&](std::chrono::seconds time) {
    return lateness(assignment, assignment.deadline + time);
  };

  BOOST_TEST(!after(std::chrono::days(7)).is_refused);
  BOOST_TEST(after(std::chrono::days(7)).percent == 70);
  BOOST_TEST(after(std::chrono::days(7) + std::chrono::seconds(1)).is_refused);
}

BOOST_AUTO_TEST_CASE(students_are_told_what_lateness_cost) {
  const auto text = [](int days, int slip_days, double percent) {
    Graded graded;
    graded.late = {.days = days, .slip_days = slip_days, .percent = percent};
    return state_of(graded) + ": " + lateness_text(graded);
  };

  BOOST_TEST(text(0, 0, 0) == "on time: on time");
  BOOST_TEST(text(1, 0, 10) == "late: 1 day late: 10 % of the points are deducted");
  BOOST_TEST(text(2, 2, 0) == "on time: 2 days late, 2 slip days used: nothing is deducted");
  BOOST_TEST(text(2, 1, 10) ==
             "late: 2 days late, 1 slip day used: 10 % of the points are deducted");
}

BOOST_AUTO_TEST_CASE(times_are_those_of_rfc_3339) {
  BOOST_TEST((parse_time("2026-12-31T23:30:00-01:00") == parse_time("2027-01-01T00:30:00.25Z")));
  for (const char* text : {"", "2027-01-15", "2027-01-15T23:59:00", "2027-02-29T00:00:00Z",
                           "2027-01-15T24:00:00Z", "2027-01-15T23:59:00+1:00"}) {
    BOOST_CHECK_THROW(parse_time(text), sys::SourceError);
  }
}

BOOST_AUTO_TEST_SUITE_END()
