// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/solver/solution.hpp"

#include <algorithm>
#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "point_contact/closed_forms/spheres.hpp"
#include "point_contact/solver/methods.hpp"
#include "system/require.hpp"

BOOST_AUTO_TEST_SUITE(beneath_test)

using Eigen::Vector3d;
using elasticity::Material;
using point_contact::AxialStress;
using point_contact::Element;
using point_contact::field_beneath;
using point_contact::Hertz;
using point_contact::hexagonal_grid;
using point_contact::Huber;
using point_contact::InteriorField;
using point_contact::Profile;
using point_contact::Solution;
using point_contact::solve_for_load;
using point_contact::square_grid;

namespace {

constexpr double load = 3.461;
const Material material(2000, 0.2385);
const double modulus = elasticity::contact_modulus(material, material);
const Hertz hertz(modulus, 0.571, load);
const double a = hertz.radius();

Solution spheres(Eigen::Index n) {
  const double side = 2 * a / 0.9;
  return solve_for_load(
      {Profile::paraboloid(0.571), modulus, hexagonal_grid(side, n), Element::pyramid}, load);
}

// The greatest difference from Huber's stresses at some places, in units of p₀.
double difference_from_huber(const Solution& solution) {
  const Huber huber(hertz, material.poisson());
  double greatest = 0;
  for (const auto& [r, angle, z] :
       {std::array{0.0, 0.0, 0.48}, {0.3, 0.7, 0.2}, {0.9, 2.0, 0.6}, {1.6, -1.0, 0.9}}) {
    const AxialStress exact = huber.stress(r * a, z * a);
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    const Vector3d at(r * a * c, r * a * s, z * a);
    Eigen::Matrix3d stress;
    stress << exact.rr * c * c + exact.tt * s * s, (exact.rr - exact.tt) * c * s, exact.rz * c,
        (exact.rr - exact.tt) * c * s, exact.rr * s * s + exact.tt * c * c, exact.rz * s,
        exact.rz * c, exact.rz * s, exact.zz;
    const Eigen::Matrix3d found = field_beneath(solution, material, at).stress;
    greatest = std::max(greatest, (found - stress).cwiseAbs().maxCoeff() / hertz.peak_pressure());
  }
  return greatest;
}

}  // namespace

BOOST_AUTO_TEST_CASE(stresses_beneath_two_spheres_are_hubers_to_the_second_order) {
  const double coarse = difference_from_huber(spheres(32));
  const double fine = difference_from_huber(spheres(96));

  BOOST_TEST(fine < 1e-4, fine);
  BOOST_TEST(coarse / fine > 5, coarse / fine);  // nine by the second order
}

BOOST_AUTO_TEST_CASE(just_beneath_the_middle_the_body_is_displaced_by_half_the_approach) {
  // alike bodies share it
  const Solution solution = spheres(48);
  const double u = field_beneath(solution, material, {0, 0, 1e-9 * a}).displacement.z();

  BOOST_TEST(std::abs(u / (solution.approach / 2) - 1) < 1e-3);
}

BOOST_AUTO_TEST_CASE(the_surface_is_drawn_towards_the_middle_as_hertz_says) {
  // Johnson 3.41b, 3.42b: u_r = −[(1−2ν)(1+ν)/(3E)] (a²/r) p₀ {1 − (1−r²/a²)^{3/2}}, outside 1
  const Solution solution = spheres(96);
  const double scale = material.local_compliance() / 3 * hertz.peak_pressure() * a;
  for (const auto& [r, angle] : {std::pair{0.2, 0.4}, {0.77, -2.1}, {1.0, 1.1}, {1.9, 3.0}}) {
    const double inside = r < 1 ? 1 - std::pow(1 - r * r, 1.5) : 1;
    const point_contact::Vector2 direction(std::cos(angle), std::sin(angle));
    const Vector3d u = displacement_of_surface(solution, material, r * a * direction);
    // at the edge as much as a node there carries
    const double allowed = (r == 1 ? 2e-3 : 2e-4) * scale;
    BOOST_TEST(std::abs(u.head<2>().dot(direction) + scale / r * inside) < allowed);
    BOOST_TEST(std::abs(u.x() * direction.y() - u.y() * direction.x()) < allowed);
    const double half_gap = (solution.approach - 0.571 * r * r * a * a / 2) / 2;
    if (r < 1) BOOST_TEST(std::abs(u.z() / half_gap - 1) < 1e-4);
  }
}

BOOST_AUTO_TEST_CASE(far_beneath_the_contact_is_a_force) {
  const Solution solution = spheres(48);
  const double z = 50 * a;
  const double stress = field_beneath(solution, material, {0, 0, z}).stress(2, 2);

  // σ_zz = −3P/(2πz²) but for some (a/z)²
  BOOST_TEST(std::abs(stress * z * z * 2 * std::numbers::pi / (-3 * load) - 1) < 1e-3);
}

BOOST_AUTO_TEST_CASE(what_all_elements_do_at_a_distance_is_the_same) {
  const Solution by_pyramids = spheres(64);
  const Vector3d at(0.3 * a, -0.2 * a, 0.5 * a);
  const point_contact::Vector2 beside(1.9 * a, 0.4 * a);
  const InteriorField field = field_beneath(by_pyramids, material, at);
  const Vector3d displacement = displacement_of_surface(by_pyramids, material, beside);
  const point_contact::Vector2 slope = slope_of_surface(by_pyramids, modulus, beside);
  for (const Element element : {Element::bilinear, Element::uniform, Element::point}) {
    const Solution solution = solve_for_load(
        {Profile::paraboloid(0.571), modulus, square_grid(2 * a / 0.9, 64), element}, load);
    const InteriorField other = field_beneath(solution, material, at);
    BOOST_TEST_CONTEXT(name_of(element)) {
      BOOST_TEST((other.stress - field.stress).norm() < 1e-3 * field.stress.norm());
      BOOST_TEST((other.displacement - field.displacement).norm() <
                 1e-3 * field.displacement.norm());
      BOOST_TEST((displacement_of_surface(solution, material, beside) - displacement).norm() <
                 1e-3 * displacement.norm());
      BOOST_TEST((slope_of_surface(solution, modulus, beside) - slope).norm() <
                 1e-3 * slope.norm());
    }
  }
}

BOOST_AUTO_TEST_CASE(the_slope_is_that_of_the_displacements_of_both_bodies) {
  const Solution solution = spheres(48);
  const point_contact::Vector2 at(0.317 * a, 0.241 * a);
  const double step = 1e-4 * a;
  for (int axis = 0; axis < 2; ++axis) {
    const point_contact::Vector2 d = step * point_contact::Vector2::Unit(axis);
    const double rise = displacement_of_surface(solution, material, at + d).z() -
                        displacement_of_surface(solution, material, at - d).z();
    // alike bodies share it; κr is the slope in contact
    BOOST_TEST(std::abs(slope_of_surface(solution, modulus, at)[axis] - 2 * rise / (2 * step)) <
               1e-5 * 0.571 * a);
  }
}

BOOST_AUTO_TEST_CASE(places_where_the_elements_have_no_finite_answer_are_refused) {
  Solution solution = spheres(32);
  BOOST_CHECK_THROW(field_beneath(solution, material, {0, 0, 0}), sys::InvalidQuantity);
  const auto& grid = solution.grid;
  const point_contact::Vector2 node = grid.node(grid.n1 / 2, grid.n2 / 2);
  solution.element = Element::point;
  BOOST_CHECK_THROW(displacement_of_surface(solution, material, node), sys::InvalidQuantity);
  BOOST_CHECK_THROW(slope_of_surface(solution, modulus, node), sys::InvalidQuantity);
}

BOOST_AUTO_TEST_SUITE_END()
