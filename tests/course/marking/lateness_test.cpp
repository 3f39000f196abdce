// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/marking/lateness.hpp"

#include <boost/test/unit_test.hpp>

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

BOOST_AUTO_TEST_CASE(times_are_those_of_rfc_3339) {
  BOOST_TEST((parse_time("2026-12-31T23:30:00-01:00") == parse_time("2027-01-01T00:30:00.25Z")));
  for (const char* text : {"", "2027-01-15", "2027-01-15T23:59:00", "2027-02-29T00:00:00Z",
                           "2027-01-15T24:00:00Z", "2027-01-15T23:59:00+1:00"}) {
    BOOST_CHECK_THROW(parse_time(text), sys::SourceError);
  }
}

BOOST_AUTO_TEST_SUITE_END()
