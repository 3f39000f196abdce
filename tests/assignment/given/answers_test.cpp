// SPDX-License-Identifier: GPL-3.0-or-later
#include "assignment/given/answers.hpp"

#include <boost/test/unit_test.hpp>
#include <limits>
#include <set>
#include <string>

#include "assignment/assignment.hpp"
#include "assignment/programs.hpp"
#include "course/assignment/assignment.hpp"
#include "holds.hpp"

BOOST_AUTO_TEST_SUITE(answers_test)

using course::Numbers;
using course::Outcome;
using course::Program;
using programs::nominal;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

course::Checks all_checks() {
  return course::all_checks(programs::assignment(), assignment::public_checks(),
                            assignment::hidden_checks());
}

// The outcome of each check for a program whose answers are all changed in the same way.
void require_refused(const Program& program, const std::string& reason) {
  for (const auto& [id, check] : all_checks()) {
    const Outcome outcome = check(program, nominal);
    BOOST_TEST_CONTEXT(id << ": " << outcome.message) {
      BOOST_TEST(outcome.share == 0);
      BOOST_TEST(holds(outcome.message, reason));
    }
  }
}

// The right answers with one number replaced.
Program with_first(double number) {
  return [=](const std::string& task, const Numbers& in) {
    Numbers out = programs::right(task, in);
    out.front() = number;
    return out;
  };
}

}  // namespace

BOOST_AUTO_TEST_CASE(each_listed_check_has_code_and_each_code_is_listed) {
  std::size_t n_listed = 0;
  for (const course::Exercise& exercise : programs::assignment().exercises) {
    n_listed += exercise.checks.size() - (exercise.tests.empty() ? 0 : 1);  // no code decides tests
  }

  BOOST_TEST(all_checks().size() == n_listed);
}

BOOST_AUTO_TEST_CASE(nothing_but_nans_or_infinities_counts_nothing) {
  for (const double bad : {not_a_number, -infinity}) {
    require_refused(
        [=](const std::string& task, const Numbers& in) {
          return Numbers(programs::right(task, in).size(), bad);
        },
        "no number is finite");
  }
}

BOOST_AUTO_TEST_CASE(a_nan_or_infinity_at_one_place_costs_at_least_that_place) {
  // These do not look at the approach, with which the answer of a contact begins.
  const std::set<std::string> others = {"contact-convergence", "contact-load", "contact-pressure",
                                        "contact-reference", "contact-scaling"};
  for (const double bad : {not_a_number, infinity, -infinity}) {
    for (const auto& [id, check] : all_checks()) {
      const Outcome outcome = check(with_first(bad), nominal);
      BOOST_TEST((outcome.share < 1) == !others.contains(id), id << " with " << bad);
      BOOST_TEST((outcome.share < 1) == !outcome.message.empty(), id);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_nan_at_one_place_does_not_cost_the_others) {
  const course::Checks checks = all_checks();
  BOOST_TEST(checks.at("gradient-reference")(with_first(not_a_number), nominal).share == 0.9);
  BOOST_TEST(checks.at("influence-reference")(with_first(not_a_number), nominal).share == 0.9);
  BOOST_TEST(checks.at("quadrature-residual")(with_first(not_a_number), nominal).share >= 0.8);
}

BOOST_AUTO_TEST_CASE(a_contact_without_a_half_width_keeps_the_points_of_its_pressure) {
  const course::Checks checks = all_checks();
  const Program program = programs::spoiled("contact", [](Numbers& out) { out[1] = not_a_number; });

  BOOST_TEST(checks.at("contact-load")(program, nominal).share == 1);
  BOOST_TEST(checks.at("contact-gap")(program, nominal).share == 1);
  BOOST_TEST(checks.at("contact-scaling")(program, nominal).share == 0.5);
  BOOST_TEST(checks.at("contact-convergence")(program, nominal).message ==
             "the half-width is not above 0");
  BOOST_TEST(checks.at("contact-half-width")(program, nominal).share == 0);
}

BOOST_AUTO_TEST_CASE(a_pressure_with_a_nan_is_not_said_to_be_nowhere_negative) {
  const Program program = programs::spoiled("contact", [](Numbers& out) { out[9] = not_a_number; });

  for (const char* id : {"contact-load", "contact-gap", "contact-reference"}) {
    BOOST_TEST(all_checks().at(id)(program, nominal).share == 0, id);
  }
  BOOST_TEST(all_checks().at("contact-pressure")(program, nominal).share == 0.5);
}

BOOST_AUTO_TEST_CASE(an_answer_that_is_too_long_counts_nothing) {
  require_refused(
      [](const std::string& task, const Numbers& in) {
        Numbers out = programs::right(task, in);
        out.push_back(0);
        return out;
      },
      "not as many numbers as are due");
}

BOOST_AUTO_TEST_CASE(no_answer_counts_nothing) {
  require_refused([](const std::string&, const Numbers&) { return Numbers{}; },
                  "not as many numbers as are due");
}

BOOST_AUTO_TEST_CASE(zeros_count_nothing_whatever_their_symmetry) {
  require_refused([](const std::string& task,
                     const Numbers& in) { return Numbers(programs::right(task, in).size(), 0.0); },
                  "all finite numbers are zero");
}

BOOST_AUTO_TEST_CASE(a_program_that_fails_is_for_the_grader_to_tell) {
  const Program crashes = [](const std::string&, const Numbers&) -> Numbers {
    throw course::ProgramFailure("killed by SIGSEGV");
  };

  for (const auto& [id, check] : all_checks()) {
    BOOST_CHECK_THROW(check(crashes, nominal), course::ProgramFailure);
  }
}

BOOST_AUTO_TEST_CASE(a_tally_gives_its_share_and_says_where_it_failed) {
  assignment::Tally tally("x is positive");
  for (const double x : {1., -2., -3., -4., -5., 6., 7., 8.}) {
    tally.part(x > 0, assignment::at("x", x));
  }

  const Outcome outcome = tally.outcome();

  BOOST_TEST(outcome.share == 0.5);
  BOOST_TEST(outcome.message == "x is positive: not so for 4 of 8 (x = -2; x = -3; x = -4; …)");
}

BOOST_AUTO_TEST_SUITE_END()
