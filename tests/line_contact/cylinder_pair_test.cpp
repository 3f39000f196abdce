// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_contact/cylinder_pair.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>

#include "system/require.hpp"
#include "tolerances.hpp"

BOOST_AUTO_TEST_SUITE(cylinder_pair_test)

using elasticity::Material;
using line_contact::CylinderPair;
using line_contact::Radius;
using sys::InvalidQuantity;

namespace {

const Material steel(30e6, 0.3);

CylinderPair pair(double radius1, double radius2) {
  return {steel, Radius::of_cylinder("radius1", radius1), steel,
          Radius::of_cylinder("radius2", radius2)};
}

}  // namespace

BOOST_AUTO_TEST_CASE(curvatures_add) {
  BOOST_TEST(tolerance::relative_difference(pair(1, 3).relative_curvature(), 4.0 / 3) < 1e-15);
}

BOOST_AUTO_TEST_CASE(a_hollow_takes_curvature_away) {
  BOOST_TEST(tolerance::relative_difference(pair(1, -3).relative_curvature(), 2.0 / 3) < 1e-15);
}

BOOST_AUTO_TEST_CASE(a_plane_has_no_curvature) {
  const CylinderPair on_plane(steel, Radius::of_cylinder("radius1", 0.5), steel,
                              Radius::of_plane());

  BOOST_TEST(on_plane.relative_curvature() == 2);
}

BOOST_AUTO_TEST_CASE(the_gap_before_deformation_is_a_parabola) {
  BOOST_TEST(pair(1, -2).profile().gap(0.5) == 0.0625);
  BOOST_TEST(pair(1, -2).profile().gap(-0.5) == 0.0625);
}

BOOST_AUTO_TEST_CASE(the_profile_rises_with_the_relative_curvature_on_both_sides) {
  const CylinderPair cylinders = pair(2.385, 0.7);
  const double rise = cylinders.relative_curvature() / 2 * (0.31 * 0.31 - 0.3 * 0.3);

  BOOST_TEST(tolerance::relative_difference(cylinders.profile().rise(0.3, 0.31), rise) < 1e-13);
  BOOST_TEST(tolerance::relative_difference(cylinders.profile().rise(-0.3, -0.31), rise) < 1e-13);
  BOOST_TEST(cylinders.profile().is_symmetric());
}

BOOST_AUTO_TEST_CASE(the_modulus_is_that_of_both_materials) {
  const Material rubber(700, 0.48);
  const CylinderPair unlike(steel, Radius::of_plane(), rubber,
                            Radius::of_cylinder("radius2", 2.385));

  BOOST_TEST(unlike.contact_modulus() == elasticity::contact_modulus(steel, rubber));
}

BOOST_AUTO_TEST_CASE(bodies_that_do_not_touch_at_a_point_are_refused) {
  BOOST_CHECK_THROW(pair(1, -1), InvalidQuantity);
  BOOST_CHECK_THROW(pair(2, -1), InvalidQuantity);
  BOOST_CHECK_THROW(CylinderPair(steel, Radius::of_plane(), steel, Radius::of_plane()),
                    InvalidQuantity);
}

BOOST_AUTO_TEST_CASE(a_radius_of_zero_or_infinity_is_refused_by_its_name) {
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double radius : {0.0, infinity, double(NAN)}) {
    BOOST_CHECK_EXCEPTION(Radius::of_cylinder("radius2", radius), InvalidQuantity,
                          [](const InvalidQuantity& e) { return e.quantity() == "radius2"; });
  }
}

BOOST_AUTO_TEST_SUITE_END()
