// SPDX-License-Identifier: GPL-3.0-or-later
#include "assignment/assignment.hpp"

#include <boost/test/unit_test.hpp>
#include <set>

#include "assignment/programs.hpp"

BOOST_AUTO_TEST_SUITE(valid_variant_test)

using programs::nominal;

namespace {

bool is_valid_with(const std::string& quantity, double value) {
  course::Variant variant = nominal;
  variant.quantities.at(quantity) = value;
  return assignment::is_valid(variant);
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_papers_own_case_is_valid) {
  BOOST_TEST(assignment::is_valid(nominal));
}

BOOST_AUTO_TEST_CASE(the_theory_asks_for_small_contacts_and_strains) {
  BOOST_TEST(!is_valid_with("radius1", 0.001));
  BOOST_TEST(!is_valid_with("line_load", 4e7));
  BOOST_TEST(!is_valid_with("peak_pressure", 6e9));
}

BOOST_AUTO_TEST_CASE(the_grid_reaches_beyond_the_contact_but_not_far) {
  BOOST_TEST(!is_valid_with("nodes", 81));
  BOOST_TEST(!is_valid_with("nodes", 141));
  BOOST_TEST(!is_valid_with("spacing", 14e-6));
  BOOST_TEST(!is_valid_with("line_load", 60e3));
}

BOOST_AUTO_TEST_CASE(materials_are_those_of_solids) {
  BOOST_TEST(!is_valid_with("young1", 1e8));
  BOOST_TEST(!is_valid_with("young2", 2e12));
  BOOST_TEST(!is_valid_with("poisson1", 0.5));
  BOOST_TEST(!is_valid_with("poisson2", -0.1));
}

BOOST_AUTO_TEST_CASE(the_datum_lies_far_off) {
  BOOST_TEST(!is_valid_with("datum", 0.002));
}

BOOST_AUTO_TEST_CASE(a_variant_without_a_quantity_is_no_variant) {
  course::Variant variant = nominal;
  variant.quantities.erase("radius2");
  BOOST_CHECK_THROW(assignment::is_valid(variant), std::out_of_range);
}

BOOST_AUTO_TEST_CASE(a_class_of_300_gets_300_different_valid_variants) {
  const course::Assignment description = programs::assignment();
  std::set<std::map<std::string, double>> seen;
  for (int i = 0; i < 300; ++i) {
    const course::Variant variant = course::variant_of(description, "student" + std::to_string(i),
                                                       "a seed", assignment::is_valid);
    BOOST_TEST(assignment::is_valid(variant));
    seen.insert(variant.quantities);
  }
  BOOST_TEST(seen.size() == 300U);
}

BOOST_AUTO_TEST_SUITE_END()
