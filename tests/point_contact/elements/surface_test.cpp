// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/elements/interior.hpp"

#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "numerics/quadrature.hpp"

BOOST_AUTO_TEST_SUITE(surface_test)

using Eigen::Vector3d;
using elasticity::Material;
using point_contact::cross;
using point_contact::interior_field;
using point_contact::Patch;
using point_contact::surface_displacement;
using point_contact::surface_gradient;
using point_contact::Vector2;

namespace {

const std::array<Vector2, 3> triangle = {Vector2(0.1, -0.3), Vector2(1.7, 0.2),
                                         Vector2(0.6, 1.385)};
const std::array<double, 3> values = {0.7, -0.4, 1.9};
const Patch on_triangle = Patch::triangle(triangle, values);
const Material material(2.5, 0.2385);

const std::array<Vector2, 4> rectangle = {Vector2(0.1, -0.3), Vector2(1.3, 0.2),
                                          Vector2(0.95, 1.04), Vector2(-0.25, 0.54)};
const Patch on_rectangle = Patch::bilinear(rectangle, {0.7, -0.4, 2.2, 1.9});
const Patch on_cell = Patch::uniform(rectangle, 1.385);

Vector3d displacement(const Vector2& at) {
  return surface_displacement(on_triangle, material, at);
}

// Forces of Johnson 3.18 at z = 0 added up over the triangle by quadrature, from a point outside
// it.
double by_quadrature(const Vector2& at, int which) {
  numerics::Quadrature outer, inner;
  const Vector2 b = triangle[1] - triangle[0];
  const Vector2 c = triangle[2] - triangle[0];
  const auto over_v = [&](double u) {
    const auto at_v = [&](double v) {
      const Vector2 d = at - (triangle[0] + u * b + v * c);
      const double p = values[0] + u * (values[1] - values[0]) + v * (values[2] - values[0]);
      const double r = d.norm();
      return which == 2 ? p / r : p * d[which] / (r * r);
    };
    return inner.smooth(at_v, 0, 1 - u, 1e-13, {"v", u}).value;
  };
  const double integral = cross(b, c) * outer.smooth(over_v, 0, 1, 1e-12, {"u", 0}).value;
  return which == 2 ? material.integral_compliance() / 2 * integral
                    : -material.local_compliance() / (2 * std::numbers::pi) * integral;
}

}  // namespace

BOOST_AUTO_TEST_CASE(it_is_the_sum_of_forces) {
  for (const Vector2& at :
       {Vector2(2.4, 1.1), Vector2(-0.6, 0.3), Vector2(0.9, -0.5), Vector2(-7.7, 13.1)}) {
    for (const int which : {0, 1, 2}) {
      BOOST_TEST(std::abs(displacement(at)[which] - by_quadrature(at, which)) < 1e-11);
    }
  }
}

// ∫ p (P−Q)/r² dA to forty digits, of which 33 stand here, in polar coordinates about P, on
// corners, edges, inside, outside: mpmath 1.3.0 with mp.dps = 50, Σ over edges of quad(−(Q−P)/r ∫₀ʳ
// p dr' h/(h²+s²), [s₁, 0, s₂]).
BOOST_AUTO_TEST_CASE(tangential_displacements_have_the_digits_of_their_integral_everywhere) {
  struct Reference {
    Vector2 at, pull;
  };
  const auto check = [](const Patch& patch, const Reference& reference) {
    const double scale = -material.local_compliance() / (2 * std::numbers::pi);
    const Vector2 pull = surface_displacement(patch, material, reference.at).head<2>() / scale;
    BOOST_TEST((pull - reference.pull).norm() < 1e-14, "at " << reference.at.transpose());
  };
  const std::vector<Reference> of_triangle = {
      {{0.1, -0.3}, {-0.645867337949919309395275209363994, -0.862808564105258941688155797859995}},
      {{0.6, 1.385}, {-0.270358639451742426277072159503527, 1.527375836755667909541547617246563}},
      {{1.22, 0.05}, {0.815352787098593092618055129418770, -0.698246124795983308993710845607413}},
      {{0.7, 0.4}, {0.260684851657583064117520496884986, -0.637335681135752490228710372871842}},
      {{0.9, -0.2}, {0.429057904204182086252416535723762, -0.959514962887061627071941407781373}},
      {{-2, 3.1}, {-0.178571821679984843512702005209405, 0.166186481428962020928482146506029}}};
  for (const Reference& reference : of_triangle) check(on_triangle, reference);
  const std::vector<Reference> of_rectangle = {
      {{0.1, -0.3}, {-0.550338752058403174552928839240192, -1.661446146557825097991490062883164}},
      {{0.95, 1.04}, {1.228367476083229761244442490148030, 1.911130881350193342413586012107835}},
      {{0.94, 0.05}, {1.173567392795521352276183182759927, -1.159617785121877638745982827056641}},
      {{0.7, 0.4}, {1.076178150691587717788102798915897, -0.833103403560500667190143172817661}},
      {{0.9, -0.2}, {0.795546321892838225690426393253087, -1.142353202270573018329270553995674}},
      {{-2, 3.1}, {-0.244877385518145670788602891215214, 0.265136198696240729653865538029131}}};
  for (const Reference& reference : of_rectangle) check(on_rectangle, reference);
}

BOOST_AUTO_TEST_CASE(the_inside_of_the_body_goes_over_into_it) {
  const Vector2 inside(0.7, 0.4);
  const Vector2 edge = (triangle[0] + triangle[2]) / 2;
  for (const Vector2& at : {inside, Vector2(edge + Vector2(1e-3, 0)), Vector2(2.1, 1.3)}) {
    const double z = 1e-9;
    for (const Patch& patch : {on_triangle, on_rectangle, on_cell}) {
      const Vector3d beneath = interior_field(patch, material, {at.x(), at.y(), z}).displacement;
      BOOST_TEST((surface_displacement(patch, material, at) - beneath).norm() < 1e-7);
    }
  }
}

BOOST_AUTO_TEST_CASE(it_is_continuous_across_edges_and_corners) {
  for (const Vector2& at :
       {triangle[0], triangle[1], triangle[2], Vector2((triangle[0] + triangle[1]) / 2),
        Vector2(2 * triangle[1] - triangle[0])}) {
    const Vector3d here = displacement(at);
    BOOST_TEST(here.allFinite());
    for (const double angle : {0.1, 1.7, 3.3, 5.0}) {
      const Vector2 beside = at + 1e-10 * Vector2(std::cos(angle), std::sin(angle));
      BOOST_TEST((displacement(beside) - here).norm() < 1e-8);
    }
  }
}

BOOST_AUTO_TEST_CASE(that_of_a_rectangle_is_continuous_too) {
  for (const Vector2& at : {rectangle[0], rectangle[2], Vector2(2 * rectangle[1] - rectangle[0])}) {
    const Vector3d here = surface_displacement(on_rectangle, material, at);
    BOOST_TEST(here.allFinite());
    for (const double angle : {0.1, 1.7, 3.3, 5.0}) {
      const Vector2 beside = at + 1e-10 * Vector2(std::cos(angle), std::sin(angle));
      BOOST_TEST((surface_displacement(on_rectangle, material, beside) - here).norm() < 1e-8);
    }
  }
}

BOOST_AUTO_TEST_CASE(the_gradient_is_that_of_the_normal_displacement) {
  const double step = 1e-5;
  const double scale = material.integral_compliance() / 2;
  for (const Patch& patch : {on_triangle, on_rectangle, on_cell}) {
    for (const Vector2& at : {Vector2(0.7, 0.4), Vector2(2.4, 1.1), Vector2(-0.6, 0.3)}) {
      const Vector2 gradient = scale * surface_gradient(patch, at);
      for (int axis = 0; axis < 2; ++axis) {
        const Vector2 d = step * Vector2::Unit(axis);
        const double difference = (surface_displacement(patch, material, at + d).z() -
                                   surface_displacement(patch, material, at - d).z()) /
                                  (2 * step);
        BOOST_TEST(std::abs(gradient[axis] - difference) < 1e-8);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(the_gradient_is_infinite_on_an_edge_of_the_load) {
  const Vector2 edge = (rectangle[0] + rectangle[1]) / 2;
  BOOST_TEST(surface_gradient(on_cell, edge + Vector2(0, 1e-9)).norm() > 20);
  BOOST_TEST(surface_gradient(on_cell, edge + Vector2(0, 1e-4)).norm() < 20 * 1.385);
}

BOOST_AUTO_TEST_CASE(far_away_it_is_a_force_at_the_centre_of_pressure) {
  // P and its centre by the triangle's own moments
  const double area = cross(triangle[1] - triangle[0], triangle[2] - triangle[0]) / 2;
  const double sum = values[0] + values[1] + values[2];
  const double load = area * sum / 3;
  Vector2 centre = Vector2::Zero();
  for (std::size_t k = 0; k < 3; ++k) centre += triangle[k] * (sum + values[k]) / (4 * sum);
  const Vector2 direction(0.6, -0.8);
  const double r = 300;  // the next term is (1/300)², rounding 1e-15·300³
  const Vector3d u = displacement(centre + r * direction);

  const double inwards = material.local_compliance() * load / (2 * std::numbers::pi * r);
  BOOST_TEST((u.head<2>() + inwards * direction).norm() < 1e-5 * inwards);
  BOOST_TEST(std::abs(u.z() / (material.integral_compliance() * load / (2 * r)) - 1) < 1e-5);
}

BOOST_AUTO_TEST_SUITE_END()
