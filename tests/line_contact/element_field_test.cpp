// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_contact/element_field.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "elasticity/concentrated_load.hpp"
#include "line_contact/cylinders.hpp"
#include "line_contact/dense_methods.hpp"
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

BOOST_AUTO_TEST_SUITE_END()
