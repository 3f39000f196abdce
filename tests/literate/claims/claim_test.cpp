// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/claims/claim.hpp"

#include <boost/test/unit_test.hpp>

using namespace literate;

BOOST_AUTO_TEST_CASE(verdicts_have_names_and_follow_from_what_holds) {
  BOOST_TEST(name_of(Verdict::confirmed) == "confirmed");
  BOOST_TEST(name_of(Verdict::partly) == "partly confirmed");
  BOOST_TEST(name_of(Verdict::refuted) == "refuted");

  BOOST_CHECK(confirmed_if(true) == Verdict::confirmed);
  BOOST_CHECK(confirmed_if(false) == Verdict::refuted);
  BOOST_CHECK(confirmed_in(11, 11) == Verdict::confirmed);
  BOOST_CHECK(confirmed_in(10, 11) == Verdict::partly);
  BOOST_CHECK(confirmed_in(0, 11) == Verdict::refuted);
}
