// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/elements/multipole.hpp"

#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <vector>

#include "tolerances.hpp"

BOOST_AUTO_TEST_SUITE(multipole_test)

using point_contact::Multipole;
using point_contact::Vector2;
using tolerance::relative_difference;

BOOST_AUTO_TEST_CASE(without_directions_the_load_is_a_force) {
  const Multipole force({});

  BOOST_TEST(force.reach() == 0);
  BOOST_TEST(relative_difference(force.potential({3, 4}), 0.2) < 1e-15);
}

BOOST_AUTO_TEST_CASE(a_smeared_force_is_that_of_a_uniform_segment) {
  // ∫ ds/|d − s e| over s from −½ to ½ on the segment's own line: ln[(x+½)/(x−½)].
  const std::array<Vector2, 1> segment = {Vector2(1, 0)};
  const Multipole smeared(segment);
  for (const double x : {1.5, 2.385, 30.0, 1e5}) {
    BOOST_TEST(relative_difference(smeared.potential({x, 0}), 2 * std::atanh(0.5 / x)) < 2e-15);
  }
  // and beside it: 2 arsinh(½/y)
  for (const double y : {1.5, 2.385, 30.0}) {
    BOOST_TEST(relative_difference(smeared.potential({0, y}), 2 * std::asinh(0.5 / y)) < 2e-15);
  }
}

BOOST_AUTO_TEST_CASE(the_order_of_smearing_does_not_matter) {
  const Vector2 a(1.3, 0.2);
  const Vector2 b(-0.4, 0.9);
  const std::array<Vector2, 3> one = {a, b, b - a};
  const std::array<Vector2, 3> other = {b - a, -a, b};
  const Vector2 d(4.1, 5.3);

  BOOST_TEST(relative_difference(Multipole(one).potential(d), Multipole(other).potential(d)) <
             1e-15);
}

BOOST_AUTO_TEST_CASE(it_reaches_to_the_farthest_corner_and_begins_at_thrice_that) {
  const std::array<Vector2, 4> hat = {Vector2(2, 0), Vector2(2, 0), Vector2(0, 1), Vector2(0, 1)};

  BOOST_TEST(relative_difference(Multipole(hat).reach(), std::sqrt(5.0)) < 1e-15);
  BOOST_TEST(Multipole(hat).begin() == 3 * Multipole(hat).reach());
}

BOOST_AUTO_TEST_SUITE_END()
