// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/partial_slip.hpp"

#include <boost/test/unit_test.hpp>

#include "message_of.hpp"

BOOST_AUTO_TEST_SUITE(partial_slip_test)

using contact::share_of_sliding;

BOOST_AUTO_TEST_CASE(a_load_of_either_sign_is_a_share_of_friction_times_load) {
  BOOST_TEST(share_of_sliding(8, 0.25, 0.5) == 0.25);
  BOOST_TEST(share_of_sliding(8, 0.25, -0.5) == 0.25);
  BOOST_TEST(share_of_sliding(8, 0.25, 0) == 0);
}

BOOST_AUTO_TEST_CASE(a_load_at_which_the_bodies_slide_is_refused_with_the_limit) {
  for (const double sliding : {2.0, -2.0, 3.0}) {
    const std::string message =
        message_of<sys::InvalidQuantity>([&] { share_of_sliding(8, 0.25, sliding); });
    BOOST_TEST(message.find("friction times load, 2: there sliding begins") != std::string::npos);
  }
}

BOOST_AUTO_TEST_CASE(friction_is_above_zero) {
  BOOST_CHECK_THROW(share_of_sliding(8, 0, 0), sys::InvalidQuantity);
}

BOOST_AUTO_TEST_SUITE_END()
