// SPDX-License-Identifier: GPL-3.0-or-later
// The outcomes of all checks for answers with NaNs, infinities or a wrong length.
#include <boost/test/unit_test.hpp>
#include <limits>
#include <set>
#include <string>

#include "assignment/programs.hpp"

BOOST_AUTO_TEST_SUITE(odd_answers_test)

using judge::Numbers;
using judge::Program;
using programs::Kind;
using programs::share;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

// A correct program, except that every answer is changed in the same way.
Program changed(const std::function<void(Numbers&)>& change) {
  return [=](const std::string& task, const Numbers& in) {
    Numbers out = programs::right(task, in);
    change(out);
    return out;
  };
}

Program with_first(double number) {
  return changed([=](Numbers& out) { out.front() = number; });
}

void require_nothing(const Program& program) {
  for (const Kind kind : {Kind::public_checks, Kind::hidden_checks}) {
    for (const judge::Check& check : programs::all(kind)) {
      BOOST_TEST(programs::outcome_of(check, program).share == 0, check.id);
    }
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(answers_without_a_number_or_with_a_wrong_length_score_nothing) {
  require_nothing(changed([](Numbers& out) { out.assign(out.size(), not_a_number); }));
  require_nothing(changed([](Numbers& out) { out.assign(out.size(), -infinity); }));
  require_nothing(changed([](Numbers& out) { out.assign(out.size(), 0); }));
  require_nothing(changed([](Numbers& out) { out.push_back(0); }));
  require_nothing(changed([](Numbers& out) { out.clear(); }));
}

BOOST_AUTO_TEST_CASE(a_nan_or_infinity_affects_only_checks_that_use_it) {
  // These ignore the approach, which is the first number of the answer.
  const std::set<std::string> others = {"contact-convergence", "contact-load", "contact-pressure",
                                        "contact-reference", "contact-scaling"};
  for (const double bad : {not_a_number, infinity, -infinity}) {
    for (const Kind kind : {Kind::public_checks, Kind::hidden_checks}) {
      for (const std::string& id : programs::failed(kind, with_first(bad))) {
        BOOST_TEST(!others.contains(id), id);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(a_nan_at_one_place_does_not_affect_other_places) {
  BOOST_TEST(share("gradient-reference", with_first(not_a_number)) == 0.9);
  BOOST_TEST(share("influence-reference", with_first(not_a_number)) == 0.9);
  BOOST_TEST(share("quadrature-residual", with_first(not_a_number)) >= 0.8);
}

BOOST_AUTO_TEST_CASE(a_contact_without_a_half_width_keeps_the_points_for_the_pressure) {
  const Program program = programs::spoiled("contact", [](Numbers& out) { out[1] = not_a_number; });

  BOOST_TEST(share("contact-load", program) == 1);
  BOOST_TEST(share("contact-gap", program) == 1);
  BOOST_TEST(share("contact-scaling", program) == 0.5);
  BOOST_TEST(share("contact-convergence", program) == 0);
  BOOST_TEST(share("contact-half-width", program) == 0);
}

BOOST_AUTO_TEST_CASE(a_pressure_with_a_nan_fails_the_checks_that_use_it) {
  const Program program = programs::spoiled("contact", [](Numbers& out) { out[9] = not_a_number; });

  for (const char* id : {"contact-load", "contact-gap", "contact-reference"}) {
    BOOST_TEST(share(id, program) == 0, id);
  }
  BOOST_TEST(share("contact-pressure", program) == 0.5);
}

BOOST_AUTO_TEST_SUITE_END()
