// SPDX-License-Identifier: GPL-3.0-or-later
#include "block/load_shapes.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "system/require.hpp"

BOOST_AUTO_TEST_SUITE(load_shapes_test)

namespace {

constexpr double peak = 238.5;
constexpr double a = 0.37;

}  // namespace

BOOST_AUTO_TEST_CASE(resultants_are_those_of_the_shapes) {
  const double pi = std::numbers::pi;
  BOOST_CHECK_CLOSE(block::normal_resultant(block::linear_fall(peak, 0.6, a)), 1.6 * peak * a,
                    1e-9);
  BOOST_CHECK_CLOSE(block::normal_resultant(block::power_fall(peak, 4, a)), 1.6 * peak * a, 1e-9);
  BOOST_CHECK_CLOSE(block::normal_resultant(block::power_fall(peak, 3, a)), 1.5 * peak * a, 1e-9);
  BOOST_CHECK_CLOSE(block::normal_resultant(block::power_fall(peak, 1, a)), peak * a, 1e-9);
  BOOST_CHECK_CLOSE(block::normal_resultant(block::power_fall(peak, 0.5, a)), 2. / 3 * peak * a,
                    1e-9);
  BOOST_CHECK_CLOSE(block::normal_resultant(block::elliptic(peak, a)), pi / 2 * peak * a, 1e-9);
  BOOST_CHECK_CLOSE(block::normal_resultant(block::cosine_fall(peak, a)), peak * a, 1e-9);
}

BOOST_AUTO_TEST_CASE(every_shape_has_its_peak_in_the_middle_and_its_value_at_the_edge) {
  for (const auto& load :
       {block::linear_fall(peak, 0, a), block::elliptic(peak, a), block::cosine_fall(peak, a),
        block::power_fall(peak, 4, a), block::power_fall(peak, 0.7, a)}) {
    BOOST_CHECK_CLOSE(load.normal(0), peak, 1e-10);
    BOOST_TEST(std::abs(load.normal(a)) < 1e-10);
    BOOST_CHECK_CLOSE(load.normal(0.21 * a), load.normal(-0.21 * a), 1e-10);
  }
  BOOST_CHECK_CLOSE(block::linear_fall(peak, 0.6, a).normal(0.5 * a), 0.8 * peak, 1e-10);
  BOOST_CHECK_CLOSE(block::power_fall(peak, 0.5, a).normal(0.25 * a), 0.5 * peak, 1e-10);
  BOOST_CHECK_CLOSE(block::cosine_fall(peak, a).normal(a / 3), 0.75 * peak, 1e-10);
}

BOOST_AUTO_TEST_CASE(scaling_multiplies_all_that_acts) {
  elasticity::Load load = block::linear_fall(peak, 0.6, a);
  load.forces = {{0.1, 3}};

  const elasticity::Load twice = block::scaled(load, 2.5);

  BOOST_CHECK_CLOSE(twice.normal(0.1), 2.5 * load.normal(0.1), 1e-10);
  BOOST_CHECK_CLOSE(block::normal_resultant(twice), 2.5 * block::normal_resultant(load), 1e-8);
}

BOOST_AUTO_TEST_CASE(shapes_out_of_range_are_refused) {
  BOOST_CHECK_THROW(block::linear_fall(0, 0.6, a), sys::InvalidQuantity);
  BOOST_CHECK_THROW(block::linear_fall(peak, -0.1, a), sys::InvalidQuantity);
  BOOST_CHECK_THROW(block::linear_fall(peak, 0.6, -a), sys::InvalidQuantity);
  BOOST_CHECK_THROW(block::power_fall(peak, 0, a), sys::InvalidQuantity);
  BOOST_CHECK_THROW(block::power_fall(peak, -0.5, a), sys::InvalidQuantity);
  BOOST_CHECK_THROW(block::cosine_fall(-peak, a), sys::InvalidQuantity);
  BOOST_CHECK_THROW(block::scaled(block::elliptic(peak, a), std::nan("")), sys::InvalidQuantity);
}

BOOST_AUTO_TEST_SUITE_END()
