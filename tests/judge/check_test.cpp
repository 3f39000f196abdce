// SPDX-License-Identifier: GPL-3.0-or-later
#include "judge/check.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>

#include "messages.hpp"

BOOST_AUTO_TEST_SUITE(check_test)

using judge::Numbers;

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

Numbers answer_to(const Numbers& answer, std::size_t count) {
  return judge::answer_of([&](const std::string&, const Numbers&) { return answer; }, "task", {1},
                          count);
}

std::string error_for(const Numbers& answer, std::size_t count) {
  return message_of<judge::NoAnswer>([&] { answer_to(answer, count); });
}

}  // namespace

BOOST_AUTO_TEST_CASE(an_answer_must_have_the_expected_number_of_numbers) {
  BOOST_TEST(answer_to({1, 2}, 2) == (Numbers{1, 2}));
  BOOST_TEST(error_for({1}, 2) == "task task: the answer must have 2 numbers");
  BOOST_TEST(error_for({1, 2, 3}, 2) == "task task: the answer must have 2 numbers");
}

BOOST_AUTO_TEST_CASE(nans_or_zeros_alone_are_no_answer) {
  BOOST_TEST(error_for({nan, -infinity}, 2) == "task task: no number is finite and not zero");
  BOOST_TEST(error_for({0, nan}, 2) == "task task: no number is finite and not zero");
}

BOOST_AUTO_TEST_CASE(an_infinity_among_numbers_counts_as_nan) {
  const Numbers found = answer_to({1, infinity, nan}, 3);

  BOOST_TEST(found[0] == 1);
  BOOST_TEST(std::isnan(found[1]));
  BOOST_TEST(std::isnan(found[2]));
  BOOST_TEST(!judge::near(infinity, infinity, 1));
}

BOOST_AUTO_TEST_CASE(a_tally_gives_the_fraction_that_holds_and_the_first_failures) {
  judge::Tally tally("x is positive");
  for (const double x : {1., -2., -3., -4., -5., 6., 7., 8.}) tally.part(x > 0, judge::at("x", x));

  const judge::Outcome outcome = tally.outcome();

  BOOST_TEST(outcome.share == 0.5);
  BOOST_TEST(outcome.message ==
             "x is positive: does not hold in 4 of 8 cases (x = -2; x = -3; x = -4; …)");
}

BOOST_AUTO_TEST_CASE(a_tally_without_failures_has_no_message) {
  judge::Tally tally("x is positive");
  tally.part(true, "x = 1");

  BOOST_TEST(tally.outcome().share == 1);
  BOOST_TEST(tally.outcome().message.empty());
}

BOOST_AUTO_TEST_SUITE_END()
