// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_contact/element_field.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "line_contact/dense_methods.hpp"
#include "line_contact/friction.hpp"
#include "line_contact/hertz.hpp"
#include "system/require.hpp"
#include "tolerances.hpp"

BOOST_AUTO_TEST_SUITE(traction_test)

using elasticity::Material;
using elasticity::PiecewiseLinearTraction;
using elasticity::Stress;
using line_contact::CylinderPair;
using line_contact::Element;
using line_contact::Hertz;
using line_contact::Problem;
using line_contact::Radius;
using line_contact::Solution;
using line_contact::traction_on;
using sys::InvalidQuantity;
using tolerance::relative_difference;

namespace {

const Material steel(30e6, 0.3);
const CylinderPair cylinders(steel, Radius::of_cylinder("radius1", 1), steel,
                             Radius::of_cylinder("radius2", 3));
constexpr double load = 2385;
const Hertz hertz(cylinders, load);
const Eigen::VectorXd frictionless;

Solution solve(const line_contact::Grid& grid, Element element = Element::triangular) {
  return line_contact::solve_by_matrix_inversion(
      Problem{cylinders.profile(), cylinders.contact_modulus(), grid, element}, load);
}

Solution two_sided() {
  return solve(line_contact::grid_of_width(2.6 * hertz.half_width(), 61));
}

// The largest difference of the three components, over the peak pressure.
double difference(const Stress& one, const Stress& other) {
  return std::max({std::abs(one.xx - other.xx), std::abs(one.zz - other.zz),
                   std::abs(one.xz - other.xz)}) /
         hertz.peak_pressure();
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_traction_takes_the_nodal_pressures_and_is_linear_between) {
  const Solution s = two_sided();
  const PiecewiseLinearTraction traction = traction_on(s, frictionless);

  for (Eigen::Index i = 0; i + 1 < s.grid.n_nodes; ++i) {
    const double middle = (s.grid.x(i) + s.grid.x(i + 1)) / 2;
    const double mean = (s.pressure[i] + s.pressure[i + 1]) / 2;
    BOOST_TEST(std::abs(traction.pressure(s.grid.x(i)) - s.pressure[i]) <
               1e-13 * hertz.peak_pressure());
    BOOST_TEST(std::abs(traction.pressure(middle) - mean) < 1e-13 * hertz.peak_pressure());
    BOOST_TEST(traction.shear(middle) == 0);
  }
}

BOOST_AUTO_TEST_CASE(the_pressure_falls_to_zero_at_the_free_neighbours_and_not_at_the_last_nodes) {
  const Solution s = two_sided();
  const PiecewiseLinearTraction traction = traction_on(s, frictionless);
  Eigen::Index last = s.grid.n_nodes - 1;
  while (s.pressure[last] == 0) --last;
  const double c = s.grid.spacing;

  BOOST_TEST(relative_difference(traction.pressure(s.grid.x(last) + 0.75 * c),
                                 0.25 * s.pressure[last]) < 1e-12);
  BOOST_TEST(traction.pressure(s.grid.x(last) + 1.001 * c) == 0);
  BOOST_TEST(traction.pressure(-s.grid.x(last) - 1.001 * c) == 0);
}

BOOST_AUTO_TEST_CASE(far_away_the_stress_is_that_of_the_load) {
  const double z = 1e5 * hertz.half_width();
  const Stress stress = traction_on(two_sided(), frictionless).stress(0, z);

  // σ_zz = −2P/(πz) (Johnson 2.15) but for (a/z)², and equilibrium to rounding
  BOOST_TEST(relative_difference(stress.zz, -2 * load / (std::acos(-1.0) * z)) < 1e-9);
}

BOOST_AUTO_TEST_CASE(a_one_sided_grid_gives_the_same_stresses_as_both_sides) {
  const double width = 2.6 * hertz.half_width();
  const Solution both = solve(line_contact::grid_of_width(width, 61));
  const Solution half = solve(line_contact::one_sided_grid(width, 31));
  const PiecewiseLinearTraction on_both = traction_on(both, frictionless);
  const PiecewiseLinearTraction on_half = traction_on(half, frictionless);

  BOOST_TEST(relative_difference(half.grid.spacing, both.grid.spacing) < 1e-14);
  for (const double x : {-1.7, -0.438, 0.0, 0.612, 1.35}) {
    for (const double z : {0.0, 0.031, 0.79, 6.2}) {
      const double at = x * hertz.half_width();
      const double depth = z * hertz.half_width();
      BOOST_TEST(difference(on_half.stress(at, depth), on_both.stress(at, depth)) < 1e-11);
    }
  }
}

BOOST_AUTO_TEST_CASE(the_shear_keeps_its_sign_and_turns_the_stress_round_with_it) {
  const Solution s = two_sided();
  const Eigen::VectorXd shear = line_contact::sliding(s, 0.37).shear;
  const PiecewiseLinearTraction forth = traction_on(s, shear);
  const PiecewiseLinearTraction back = traction_on(s, -shear);
  const double x = 0.41 * hertz.half_width();
  const double z = 0.23 * hertz.half_width();

  BOOST_TEST(relative_difference(forth.shear(x), 0.37 * forth.pressure(x)) < 1e-13);
  BOOST_TEST(forth.stress(x, 0).xz < 0);  // σ_xz = −q on the surface
  BOOST_TEST(relative_difference(forth.stress(x, 0).xz, -forth.shear(x)) < 1e-12);
  const Stress mirrored = back.stress(-x, z);
  const Stress stress = forth.stress(x, z);
  BOOST_TEST(difference(stress, {mirrored.xx, mirrored.zz, -mirrored.xz}) < 1e-11);
}

BOOST_AUTO_TEST_CASE(elements_whose_stresses_jump_are_refused) {
  const line_contact::Grid grid = line_contact::grid_of_width(2.6 * hertz.half_width(), 31);

  for (const Element element : {Element::point, Element::uniform}) {
    BOOST_CHECK_THROW(traction_on(solve(grid, element), frictionless), InvalidQuantity);
  }
}

BOOST_AUTO_TEST_CASE(a_shear_on_a_one_sided_grid_is_refused) {
  const Solution half = solve(line_contact::one_sided_grid(2.6 * hertz.half_width(), 21));

  BOOST_CHECK_THROW(traction_on(half, line_contact::sliding(half, 0.2).shear), InvalidQuantity);
}

BOOST_AUTO_TEST_SUITE_END()
