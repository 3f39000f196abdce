// SPDX-License-Identifier: GPL-3.0-or-later
#include "assignment/given/numbers.hpp"

#include <boost/test/unit_test.hpp>
#include <set>
#include <string>

BOOST_AUTO_TEST_SUITE(numbers_test)

using assignment::is_valid;
using assignment::lines_of_numbers;
using assignment::nominal_numbers;
using assignment::own_numbers;
using assignment::OwnNumbers;

namespace {

bool is_valid_with(double OwnNumbers::*quantity, double value) {
  OwnNumbers numbers = nominal_numbers();
  numbers.*quantity = value;
  return is_valid(numbers);
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_case_of_the_paper_is_valid_and_used_without_an_id) {
  BOOST_TEST(is_valid(nominal_numbers()));
  BOOST_TEST(own_numbers("").young1 == nominal_numbers().young1);
}

BOOST_AUTO_TEST_CASE(an_id_gives_the_same_numbers_on_every_machine) {
  BOOST_TEST(lines_of_numbers("ada@uni.edu") ==
             "young1 1.34e+11 Pa\n"
             "poisson1 0.4 \n"
             "young2 9.5e+10 Pa\n"
             "poisson2 0.36 \n"
             "radius1 0.0318 m\n"
             "radius2 0.0696 m\n"
             "line_load 493000 N/m\n"
             "spacing 8.8e-06 m\n"
             "nodes 129 \n"
             "peak_pressure 5.7e+06 Pa\n"
             "half_width 0.000234 m\n"
             "datum 0.2 m\n");
}

BOOST_AUTO_TEST_CASE(case_and_blanks_in_an_id_do_not_matter) {
  BOOST_TEST(lines_of_numbers(" Ada@Uni.edu\n") == lines_of_numbers("ada@uni.edu"));
}

BOOST_AUTO_TEST_CASE(three_hundred_students_have_different_valid_numbers) {
  std::set<std::string> seen;
  for (int i = 0; i < 300; ++i) {
    const std::string id = "student" + std::to_string(i);
    BOOST_TEST(is_valid(own_numbers(id)));
    seen.insert(lines_of_numbers(id));
  }
  BOOST_TEST(seen.size() == 300U);
}

BOOST_AUTO_TEST_CASE(the_grid_must_extend_a_little_beyond_the_contact) {
  BOOST_TEST(!is_valid_with(&OwnNumbers::nodes, 81));
  BOOST_TEST(!is_valid_with(&OwnNumbers::nodes, 141));
  BOOST_TEST(!is_valid_with(&OwnNumbers::spacing, 14e-6));
  BOOST_TEST(!is_valid_with(&OwnNumbers::line_load, 60e3));
}

BOOST_AUTO_TEST_CASE(strains_beyond_the_linear_range_are_invalid) {
  OwnNumbers numbers = nominal_numbers();
  numbers.line_load *= 100;
  numbers.spacing *= 10;

  BOOST_TEST(!is_valid(numbers));
}

BOOST_AUTO_TEST_SUITE_END()
