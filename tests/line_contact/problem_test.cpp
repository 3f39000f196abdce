// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_contact/problem.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "numbers.hpp"

BOOST_AUTO_TEST_SUITE(problem_test)

using line_contact::Profile;
using tolerance::relative_difference;

BOOST_AUTO_TEST_CASE(the_rise_of_a_parabola_is_accurate_to_its_own_rounding) {
  const Profile parabola = Profile::parabola(2.385);
  BOOST_TEST(relative_difference(parabola.gap(-0.5), 2.385 / 8) < tolerance::rounding);
  // κ/2 (to − from)(to + from); a difference of gaps would have seven digits
  BOOST_TEST(relative_difference(parabola.rise(1, 1 + 0x1p-30),
                                 2.385 / 2 * 0x1p-30 * (2 + 0x1p-30)) < tolerance::rounding);
  BOOST_TEST(parabola.rise(-0.3, 0.3) == 0);
  BOOST_TEST(parabola.begin() == -std::numeric_limits<double>::infinity());
}

BOOST_AUTO_TEST_CASE(a_measured_profile_passes_through_its_points_without_overshoot) {
  const std::vector<double> x{-2, -1, 0.5, 0.75, 3};
  const std::vector<double> gap{4, 1, 0, 0, 2.385};
  const Profile profile = Profile::tabulated(x, gap);
  for (std::size_t i = 0; i < x.size(); ++i)
    BOOST_TEST(std::abs(profile.gap(x[i]) - gap[i]) < 1e-14);
  for (double at = 0.5; at <= 0.75; at += 0.01) BOOST_TEST(profile.gap(at) == 0);
  for (double at = -2; at <= 3; at += 0.01) BOOST_TEST(profile.gap(at) >= 0);
  BOOST_TEST(relative_difference(profile.rise(-1, 3), 1.385) < 1e-14);
  BOOST_TEST(profile.begin() == -2);
  BOOST_TEST(profile.end() == 3);
}

BOOST_AUTO_TEST_CASE(a_finely_measured_parabola_has_the_gap_of_a_parabola) {
  std::vector<double> x, gap;
  for (int i = -50; i <= 50; ++i) {
    x.push_back(0.02 * i);
    gap.push_back(0.5 * x.back() * x.back());
  }
  const Profile profile = Profile::tabulated(x, gap);
  for (const double at : {-0.777, -0.013, 0.31, 0.905}) {
    BOOST_TEST(std::abs(profile.gap(at) - 0.5 * at * at) < 1e-4);
  }
}

BOOST_AUTO_TEST_SUITE_END()
