// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/study/two_spheres.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

BOOST_AUTO_TEST_SUITE(two_spheres_test)

using elasticity::Material;
using point_contact::Element;
using point_contact::pressure_errors;
using point_contact::PressureErrors;
using point_contact::Solution;
using point_contact::surface_errors;
using point_contact::SurfaceErrors;
using point_contact::TwoSpheres;

namespace {

const Material material(2000, 0.2385);
const TwoSpheres spheres{elasticity::contact_modulus(material, material), 0.571, 3.461};

}  // namespace

BOOST_AUTO_TEST_CASE(hertz_pressure_itself_has_no_error_in_the_pressure) {
  Solution solution = solve_spheres(spheres, Element::bilinear, 41);
  for (Eigen::Index j = 0; j < solution.grid.n2; ++j) {
    for (Eigen::Index i = 0; i < solution.grid.n1; ++i) {
      solution.pressure[solution.grid.index(i, j)] =
          spheres.hertz().pressure(solution.grid.node(i, j).norm());
    }
  }
  solution.approach = spheres.hertz().approach();
  const PressureErrors e = pressure_errors(spheres, solution);

  BOOST_TEST(e.inside < 1e-14);
  BOOST_TEST(e.largest < 1e-14);
  BOOST_TEST(std::abs(e.peak) < 1e-14);
  BOOST_TEST(std::abs(e.approach) < 1e-14);
}

BOOST_AUTO_TEST_CASE(a_shifted_pressure_has_the_shift_as_its_error) {
  Solution solution = solve_spheres(spheres, Element::uniform, 40);
  const PressureErrors before = pressure_errors(spheres, solution);
  solution.pressure *= 1.01;
  const PressureErrors after = pressure_errors(spheres, solution);

  // a hundredth of Hertz's pressure, which goes from p₀ down to 0.436 p₀ at 0.9 a
  BOOST_TEST(std::abs(after.peak - before.peak - 0.01) < 1e-4);
  BOOST_TEST(after.inside > 0.0043);
  BOOST_TEST(after.inside < 0.01);
}

BOOST_AUTO_TEST_CASE(slopes_and_stresses_are_best_with_pyramids_and_useless_with_forces) {
  const auto errors = [](Element element) {
    return surface_errors(spheres, material, solve_spheres(spheres, element, 40));
  };
  const SurfaceErrors pyramid = errors(Element::pyramid);
  const SurfaceErrors uniform = errors(Element::uniform);
  const SurfaceErrors point = errors(Element::point);

  BOOST_TEST(uniform.slope > 5 * pyramid.slope);
  BOOST_TEST(point.slope > 5 * uniform.slope);
  BOOST_TEST(uniform.stress > 5 * pyramid.stress);
  BOOST_TEST(point.stress > 0.1);
}

BOOST_AUTO_TEST_CASE(the_bound_holds_what_the_tolerance_leaves) {
  const Solution solution = solve_spheres(spheres, Element::pyramid, 64);
  BOOST_TEST(pressure_bound(solution) < 1e-8);
  BOOST_TEST(pressure_bound(solution) > 1e-13);
}

BOOST_AUTO_TEST_SUITE_END()
