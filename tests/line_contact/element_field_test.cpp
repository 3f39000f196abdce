// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_contact/element_field.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "elasticity/concentrated_load.hpp"
#include "line_contact/cylinder_friction.hpp"
#include "line_contact/cylinders.hpp"
#include "line_contact/dense_methods.hpp"
#include "line_contact/friction.hpp"
#include "random_inputs.hpp"
#include "system/require.hpp"
#include "tolerances.hpp"

BOOST_AUTO_TEST_SUITE(element_field_test)

using elasticity::Stress;
using line_contact::CylinderPair;
using line_contact::Element;
using line_contact::Hertz;
using line_contact::Radius;
using line_contact::Solution;

namespace {

const elasticity::Material steel(30e6, 0.3);
const CylinderPair cylinders(steel, Radius::of_cylinder("radius1", 1), steel,
                             Radius::of_cylinder("radius2", 3));
const Hertz hertz(cylinders, 2385);
const double a = hertz.half_width();
const double p0 = hertz.peak_pressure();

line_contact::Problem problem_of(Element element) {
  return {cylinders.profile(), cylinders.contact_modulus(), line_contact::grid_around(a, 91),
          element};
}

Solution solution_of(Element element) {
  return line_contact::solve_by_matrix_inversion(problem_of(element), 2385);
}

double distance(const Stress& s, const Stress& t) {
  return std::max({std::abs(s.xx - t.xx), std::abs(s.zz - t.zz), std::abs(s.xz - t.xz)});
}

}  // namespace

BOOST_AUTO_TEST_CASE(at_the_nodes_the_slope_is_that_of_equation_2_on_the_grid) {
  const Solution solution = solution_of(Element::triangular);
  const line_contact::Slopes slopes =
      surface_slopes(problem_of(Element::triangular), solution, 0 * solution.pressure, 0);
  for (const Eigen::Index i : {3, 31, 45, 60}) {
    const double slope = surface_slope(solution, cylinders.contact_modulus(), solution.grid.x(i));
    BOOST_TEST(std::abs(slope - slopes.of_pressure[i]) < 1e-12 * a);
  }
}

BOOST_AUTO_TEST_CASE(beneath_triangles_the_stress_is_that_of_their_piecewise_linear_traction) {
  const Solution solution = solution_of(Element::triangular);
  const auto traction = line_contact::traction_on(solution, {});
  for (const double share : {-1.3, -0.385, 0.0, 0.7}) {
    for (const double depth : {0.01, 0.385, 3.1}) {
      BOOST_TEST(distance(stress_beneath(solution, share * a, depth * a),
                          traction.stress(share * a, depth * a)) < 1e-12 * p0);
    }
  }
}

BOOST_AUTO_TEST_CASE(beneath_every_kind_of_element_the_stress_is_near_mcewen) {
  for (const Element element : {Element::point, Element::uniform, Element::triangular}) {
    const Solution solution = solution_of(element);
    for (const double share : {-0.9, 0.1, 0.5}) {
      BOOST_TEST(distance(stress_beneath(solution, share * a, 0.385 * a),
                          line_contact::McEwen(hertz).stress(share * a, 0.385 * a)) < 3e-3 * p0);
    }
  }
}

BOOST_AUTO_TEST_CASE(far_from_every_kind_of_element_slope_and_stress_are_those_of_the_load) {
  const elasticity::Material both(cylinders.contact_modulus(), 0);
  const elasticity::ConcentratedLoad force(2385);
  const double x = 2.385e3 * a;
  for (const Element element : {Element::point, Element::uniform, Element::triangular}) {
    const Solution solution = solution_of(element);
    const double expected = normal_gradient(both, force, x);
    const double slope = surface_slope(solution, cylinders.contact_modulus(), x);
    BOOST_TEST(std::abs(slope / expected - 1) < 1e-7);
    const Stress of_force = stress_under(force, x, x);
    BOOST_TEST(distance(stress_beneath(solution, x, x), of_force) < 1e-6 * std::abs(of_force.xx));
  }
}

BOOST_AUTO_TEST_CASE(a_slope_that_is_infinite_is_refused) {
  const Solution forces = solution_of(Element::point);
  BOOST_CHECK_THROW(surface_slope(forces, cylinders.contact_modulus(), forces.grid.x(45)),
                    sys::InvalidQuantity);
}

BOOST_AUTO_TEST_SUITE(shear_search)

using line_contact::CylinderPair;
using line_contact::find_greatest_shear;
using line_contact::Hertz;
using line_contact::Radius;
using line_contact::ShearPoint;
using line_contact::SlidingHertz;
using std::numbers::phi;

namespace {

const elasticity::Material steel(30e6, 0.3);
const Hertz hertz(CylinderPair(steel, Radius::of_cylinder("radius1", 1), steel,
                               Radius::of_cylinder("radius2", 3)),
                  2385);
const double a = hertz.half_width();

ShearPoint beneath_sliding(double friction) {
  const SlidingHertz sliding(hertz, friction);
  return find_greatest_shear([&](double x, double z) { return sliding.stress(x, z); }, a, 0.1 * a);
}

}  // namespace

BOOST_AUTO_TEST_CASE(without_friction_the_greatest_shear_is_on_the_axis_at_the_golden_ratio) {
  // p₀ φ^(−5/2) at z = a/√φ: see mcewen_test. The place is known to the root of a rounding.
  const line_contact::McEwen mcewen(hertz);
  const ShearPoint greatest =
      find_greatest_shear([&](double x, double z) { return mcewen.stress(x, z); }, a, 0.1 * a);

  BOOST_TEST(tolerance::relative_difference(greatest.shear,
                                            hertz.peak_pressure() * std::pow(phi, -2.5)) < 1e-13);
  BOOST_TEST(std::abs(greatest.x) < 3e-7 * a);
  BOOST_TEST(std::abs(greatest.z - a / std::sqrt(phi)) < 3e-7 * a);
}

BOOST_AUTO_TEST_CASE(no_point_beneath_sliding_cylinders_has_a_greater_shear) {
  RandomInputs random(72);
  for (const double friction : {-0.31, 0.1, 0.2}) {
    const SlidingHertz sliding(hertz, friction);
    const ShearPoint greatest = beneath_sliding(friction);
    for (int i = 0; i < 5000; ++i) {
      const double x = a * random.uniform(-1.2, 1.2);
      const double z = a * random.uniform(0.1, 1.6);
      BOOST_TEST(sliding.stress(x, z).max_shear() <= greatest.shear);
    }
  }
}

BOOST_AUTO_TEST_CASE(the_place_turns_with_the_shear_and_keeps_the_least_depth) {
  const ShearPoint right = beneath_sliding(0.2);
  const ShearPoint left = beneath_sliding(-0.2);

  BOOST_TEST(std::abs(right.x + left.x) < 1e-6 * a);
  BOOST_TEST(std::abs(right.z - left.z) < 1e-6 * a);
  BOOST_TEST(beneath_sliding(2).z == 0.1 * a);
}

BOOST_AUTO_TEST_CASE(lengths_that_are_not_positive_are_refused) {
  const auto stress = [](double, double) { return elasticity::Stress{}; };
  BOOST_CHECK_THROW(find_greatest_shear(stress, 0, 1), sys::InvalidQuantity);
  BOOST_CHECK_THROW(find_greatest_shear(stress, 1, 0), sys::InvalidQuantity);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(traction)

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

BOOST_AUTO_TEST_SUITE_END()
