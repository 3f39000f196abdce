// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/elements/interior.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "system/require.hpp"

BOOST_AUTO_TEST_SUITE(force_test)

using Eigen::Vector3d;
using elasticity::Material;
using point_contact::field_of_force;
using point_contact::InteriorField;
using point_contact::Patch;
using point_contact::Vector2;

namespace {

const Material material(2.5, 0.2385);

}  // namespace

BOOST_AUTO_TEST_CASE(a_force_is_the_limit_of_a_pressure_on_a_small_cell) {
  const double side = 2e-3;
  const std::array<Vector2, 4> cell = {Vector2(-side / 2, -side / 2), Vector2(side / 2, -side / 2),
                                       Vector2(side / 2, side / 2), Vector2(-side / 2, side / 2)};
  const double force = 1.385;
  for (const Vector3d& at : {Vector3d(0.3, -0.2, 0.4), Vector3d(0, 0, 0.7), Vector3d(1, 2, 0.1)}) {
    const InteriorField of_cell =
        interior_field(Patch::uniform(cell, force / (side * side)), material, at);
    const InteriorField f = field_of_force(force, material, at);
    // but for some (side/distance)²
    BOOST_TEST((f.displacement - of_cell.displacement).norm() < 1e-4 * f.displacement.norm());
    BOOST_TEST((f.stress - of_cell.stress).norm() < 1e-4 * f.stress.norm());
  }
}

BOOST_AUTO_TEST_CASE(its_stresses_are_in_equilibrium) {
  const Vector3d at(0.3, -0.2, 0.4);
  const double step = 1e-4;
  Vector3d divergence = Vector3d::Zero();
  for (int j = 0; j < 3; ++j) {
    const Vector3d d = step * Vector3d::Unit(j);
    divergence += (field_of_force(1, material, at + d).stress.col(j) -
                   field_of_force(1, material, at - d).stress.col(j)) /
                  (2 * step);
  }
  BOOST_TEST(divergence.norm() < 1e-5 * field_of_force(1, material, at).stress.norm());
}

BOOST_AUTO_TEST_CASE(the_surface_is_refused) {
  BOOST_CHECK_THROW(field_of_force(1, material, {1, 0, 0}), sys::InvalidQuantity);
}

BOOST_AUTO_TEST_SUITE_END()
