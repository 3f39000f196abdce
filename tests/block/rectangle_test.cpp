// SPDX-License-Identifier: GPL-3.0-or-later
#include "block/rectangle.hpp"

#include <boost/test/unit_test.hpp>

#include "system/require.hpp"

BOOST_AUTO_TEST_SUITE(rectangle_test)

BOOST_AUTO_TEST_CASE(block_of_2_by_1_inches_has_the_printed_mass_properties) {
  // Ruggiero (2001), Appendix 2: six and seven digits
  const double printed_mass = 1.464799e-03;

  const block::MassProperties p = block::mass_properties({2, 1}, printed_mass / 2);

  const double digits = 5e-4;  // percent: half a unit of the sixth digit printed
  BOOST_CHECK_CLOSE(p.mass, printed_mass, 1e-10);
  BOOST_CHECK_CLOSE(p.centre_y, -0.5, 1e-10);
  BOOST_CHECK_CLOSE(p.about_origin.ixx, 4.88266e-04, digits);
  BOOST_CHECK_CLOSE(p.about_origin.iyy, 4.88266e-04, digits);
  BOOST_CHECK_CLOSE(p.about_origin.izz, 9.76532e-04, digits);
  BOOST_CHECK_CLOSE(p.about_centre.ixx, 1.22067e-04, digits);
  BOOST_CHECK_CLOSE(p.about_centre.iyy, 4.88266e-04, digits);
  BOOST_CHECK_CLOSE(p.about_centre.izz, 6.10333e-04, digits);
}

BOOST_AUTO_TEST_CASE(density_and_sizes_must_be_positive) {
  BOOST_CHECK_THROW(block::mass_properties({2, 1}, 0), sys::InvalidQuantity);
  BOOST_CHECK_THROW(block::Rectangle(0, 1), sys::InvalidQuantity);
  BOOST_CHECK_THROW(block::Rectangle(2, -1), sys::InvalidQuantity);
}

BOOST_AUTO_TEST_SUITE_END()
