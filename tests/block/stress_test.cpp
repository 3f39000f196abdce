// SPDX-License-Identifier: GPL-3.0-or-later
#include "block/stress.hpp"

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(stress_test)

BOOST_AUTO_TEST_CASE(out_of_plane_stress_is_poisson_times_the_sum_of_the_others) {
  const elasticity::Material material(2.1e5, 0.27);

  const block::Stress s = block::stress(block::lame(material), {1.3e-3, -0.8e-3, 0.5e-3});

  BOOST_CHECK_CLOSE(s.yy, 0.27 * (s.xx + s.zz), 1e-10);
  BOOST_CHECK_CLOSE(s.xz, 2.1e5 / (2 * 1.27) * 0.5e-3, 1e-10);
  // ε_yy = 0 = [σ_yy − ν(σ_xx + σ_zz)]/E, and ε_xx by the inverse law
  BOOST_CHECK_CLOSE((s.xx - 0.27 * (s.zz + s.yy)) / 2.1e5, 1.3e-3, 1e-10);
}

BOOST_AUTO_TEST_CASE(principal_stresses_are_those_of_mohrs_circle) {
  const auto principal = block::principal_stresses({50, -30, 30, 70});

  BOOST_CHECK_CLOSE(principal[0], 70.0, 1e-10);
  BOOST_CHECK_CLOSE(principal[1], 60.0, 1e-10);
  BOOST_CHECK_CLOSE(principal[2], -40.0, 1e-10);
}

BOOST_AUTO_TEST_CASE(von_mises_is_the_tension_of_a_bar_and_root_three_times_a_shear) {
  BOOST_CHECK_CLOSE(block::von_mises({123, 0, 0, 0}), 123.0, 1e-10);
  BOOST_CHECK_CLOSE(block::von_mises({0, 0, 10, 0}), 17.320508075688773, 1e-10);
  BOOST_TEST(block::von_mises({7, 7, 0, 7}) == 0);
}

BOOST_AUTO_TEST_SUITE_END()
