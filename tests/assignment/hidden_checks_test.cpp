// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <map>
#include <set>

#include "assignment/programs.hpp"

BOOST_AUTO_TEST_SUITE(hidden_checks_test)

using judge::Numbers;
using judge::Program;
using programs::Kind;
using programs::misled;
using programs::reporting;
using programs::scaled;
using programs::spoiled;

namespace {

std::map<std::string, double> shares(const Program& program) {
  std::map<std::string, double> found;
  for (const auto& check : programs::all(Kind::hidden_checks)) {
    found[check.id] = programs::outcome_of(check, program).share;
  }
  return found;
}

void require_failed(const Program& program, const std::set<std::string>& expected) {
  const auto found = programs::failed(Kind::hidden_checks, program);
  BOOST_TEST(found == expected, boost::test_tools::per_element());
}

// Programs that are wrong in every task, each in a different way.
std::vector<Program> wrong_programs() {
  std::vector<Program> list;
  for (const double factor : {-1., 2., 1 + 1e-5}) {
    list.emplace_back([=](const std::string& task, const Numbers& in) {
      Numbers out = programs::right(task, in);
      for (double& number : out) number *= factor;
      return out;
    });
  }
  return list;
}

}  // namespace

BOOST_AUTO_TEST_CASE(correct_functions_pass_every_check_with_any_numbers) {
  programs::require_right(Kind::hidden_checks);
}

BOOST_AUTO_TEST_CASE(a_wrong_factor_scores_almost_nothing) {
  for (const double factor : {-1., 2., 1.001}) {
    for (const auto& [task, ids] : std::map<std::string, std::set<std::string>>{
             {"gradient", {"gradient-far-digits", "gradient-reference"}},
             {"gradient_by_quadrature", {"quadrature-reference"}},
             {"displacement", {"displacement-other", "displacement-reference"}},
             {"influence", {"influence-far", "influence-reference"}},
             {"contact", {"contact-half-width", "contact-reference"}}}) {
      const auto found = shares(scaled(task, factor));
      for (const std::string& id : ids) {
        // Far away the slope is smaller than the tolerance.
        BOOST_TEST(found.at(id) < 0.2, task << " times " << factor << ", " << id);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(each_task_is_graded_separately) {
  require_failed(scaled("gradient", 2), {"gradient-far-digits", "gradient-reference"});
  require_failed(scaled("displacement", 2), {"displacement-other", "displacement-reference"});
  require_failed(scaled("influence", 2), {"influence-far", "influence-reference"});
  require_failed(scaled("contact", 2), {"contact-half-width", "contact-reference"});
}

BOOST_AUTO_TEST_CASE(an_error_must_cover_the_true_slope_and_be_small) {
  for (const double claimed : {0., 1.}) {
    require_failed(reporting([=](double, double) { return claimed; }), {"quadrature-honest"});
  }
}

BOOST_AUTO_TEST_CASE(an_error_that_is_the_same_everywhere_is_not_an_estimate) {
  require_failed(reporting([](double, double greatest) { return 5e-7 * greatest; }),
                 {"quadrature-honest"});
}

BOOST_AUTO_TEST_CASE(an_error_may_have_a_small_minimum) {
  require_failed(
      reporting([](double error, double greatest) { return std::max(error, 1e-10 * greatest); }),
      {});
}

BOOST_AUTO_TEST_CASE(a_contact_that_uses_the_first_material_twice_is_wrong_for_other_pairs) {
  const Program one_body = misled("contact", [](Numbers& in) {
    in[3] = in[0];
    in[4] = in[1];
  });
  const auto found = shares(one_body);
  BOOST_TEST(found.at("contact-reference") < 1);
  BOOST_TEST(found.at("contact-half-width") < 1);
}

// A program that handles the pressures up to a number, and takes all others for that one.
Program knowing_pressures_up_to(double most) {
  return [=](const std::string& task, Numbers in) {
    if (task == "gradient_by_quadrature" || task == "displacement") in[2] = std::min(in[2], most);
    return programs::right(task, in);
  };
}

BOOST_AUTO_TEST_CASE(programs_that_know_only_some_pressures_lose_points) {
  const Program without_quadrature = knowing_pressures_up_to(assignment::shape::triangle);
  const Program without_waves = knowing_pressures_up_to(assignment::shape::one_sided);
  for (const char* student : programs::ids) {
    for (const char* id : {"quadrature-reference", "quadrature-honest", "displacement-reference"}) {
      BOOST_TEST(programs::share(id, without_quadrature, student) < 0.1, id);
      BOOST_TEST(programs::share(id, without_waves, student) < 0.85, id);
    }
    BOOST_TEST(programs::share("displacement-other", without_quadrature, student) < 0.1);
  }
}

BOOST_AUTO_TEST_CASE(digits_lost_far_away_cost_only_part_of_the_points) {
  const Program losing = spoiled("influence", [](Numbers& out) { out.back() *= 1 + 1e-7; });
  const auto found = shares(losing);
  BOOST_TEST(found.at("influence-far") == 0.8);
  BOOST_TEST(found.at("influence-reference") == 0.9);
}

// A message that depended on the size of the error would reveal the correct number.
BOOST_AUTO_TEST_CASE(messages_do_not_depend_on_the_size_of_the_error) {
  const auto programs = wrong_programs();
  for (const auto& check : programs::all(Kind::hidden_checks)) {
    if (check.id == "quadrature-honest") continue;  // the factor also changes its reported errors
    const std::string message = programs::outcome_of(check, programs[0]).message;
    BOOST_TEST(!message.empty(), check.id);
    BOOST_TEST(programs::outcome_of(check, programs[1]).message == message, check.id);
  }
}

BOOST_AUTO_TEST_SUITE_END()
