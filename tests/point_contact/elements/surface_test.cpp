// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/elements/surface.hpp"

#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "numerics/quadrature.hpp"
#include "point_contact/elements/interior.hpp"

BOOST_AUTO_TEST_SUITE(surface_test)

using Eigen::Vector3d;
using elasticity::Material;
using point_contact::cross;
using point_contact::interior_field;
using point_contact::surface_displacement;
using point_contact::Vector2;

namespace {

const std::array<Vector2, 3> triangle = {Vector2(0.1, -0.3), Vector2(1.7, 0.2),
                                         Vector2(0.6, 1.385)};
const std::array<double, 3> values = {0.7, -0.4, 1.9};
const Material material(2.5, 0.2385);

Vector3d displacement(const Vector2& at) {
  return surface_displacement(triangle, values, material, at);
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

BOOST_AUTO_TEST_CASE(the_inside_of_the_body_goes_over_into_it) {
  const Vector2 inside(0.7, 0.4);
  const Vector2 edge = (triangle[0] + triangle[2]) / 2;
  for (const Vector2& at : {inside, Vector2(edge + Vector2(1e-3, 0)), Vector2(2.1, 1.3)}) {
    const double z = 1e-9;
    const Vector3d beneath =
        interior_field(triangle, values, material, {at.x(), at.y(), z}).displacement;
    BOOST_TEST((displacement(at) - beneath).norm() < 1e-7);
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
