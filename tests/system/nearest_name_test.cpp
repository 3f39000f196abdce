// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/nearest_name.hpp"

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(nearest_name_test)

BOOST_AUTO_TEST_CASE(only_a_similar_name_is_suggested) {
  BOOST_TEST(sys::suggestion("lenght", {"length", "width"}) == ", did you mean 'length'?");
  BOOST_TEST(sys::suggestion("mass", {"length", "width"}) == "");
  BOOST_TEST(sys::suggestion("ab", {"cd"}) == "");
  BOOST_TEST(sys::suggestion("x", {}) == "");
}

BOOST_AUTO_TEST_SUITE_END()
