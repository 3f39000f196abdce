// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/elements/element.hpp"

#include <algorithm>
#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "point_contact/polar_quadrature.hpp"
#include "tolerances.hpp"

BOOST_AUTO_TEST_SUITE(polygon_test)

using point_contact::cross;
using point_contact::linear_potential;
using point_contact::uniform_potential;
using point_contact::Vector2;
using tolerance::relative_difference;

namespace {

const std::array<Vector2, 3> triangle = {Vector2(0.1, -0.3), Vector2(1.7, 0.2),
                                         Vector2(0.6, 1.385)};
const std::array<double, 3> values = {0.7, -0.4, 1.9};

// The coordinates of a point as weights of the corners.
std::array<double, 3> weights(const Vector2& at) {
  const double area = cross(triangle[1] - triangle[0], triangle[2] - triangle[0]);
  const double second = cross(at - triangle[0], triangle[2] - triangle[0]) / area;
  const double third = cross(triangle[1] - triangle[0], at - triangle[0]) / area;
  return {1 - second - third, second, third};
}

double linear_pressure(const Vector2& at) {
  const auto w = weights(at);
  // a little beyond the edges too, where rounding may put the ends of a ray
  if (*std::min_element(w.begin(), w.end()) < -1e-9) return 0;
  return w[0] * values[0] + w[1] * values[1] + w[2] * values[2];
}

// On corners, on edges, on an edge's line, inside and outside.
std::vector<Vector2> places() {
  const Vector2 on_edge = 0.3 * triangle[0] + 0.7 * triangle[1];
  const Vector2 beyond_edge = 2.385 * triangle[1] - 1.385 * triangle[0];
  return {triangle[0], triangle[2], on_edge, beyond_edge, {0.7, 0.4}, {0.9, -0.2}, {-2.0, 3.1}};
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_linear_pressure_displaces_as_its_quadrature_says) {
  for (const Vector2& at : places()) {
    const double by_quadrature = polar_potential(
        linear_pressure,
        {{triangle[0], triangle[1]}, {triangle[1], triangle[2]}, {triangle[2], triangle[0]}}, at);
    BOOST_TEST_CONTEXT("at " << at.transpose()) {
      BOOST_TEST(std::abs(linear_potential(triangle, values, at) - by_quadrature) < 1e-8);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_linear_pressure_with_equal_values_is_a_uniform_one) {
  for (const Vector2& at : places()) {
    BOOST_TEST(std::abs(linear_potential(triangle, {1, 1, 1}, at) -
                        uniform_potential(triangle, at)) < 1e-15);
  }
}

BOOST_AUTO_TEST_CASE(potentials_of_parts_add_up_to_that_of_the_whole) {
  // Cut from a corner to the middle of the opposite side.
  const Vector2 middle = (triangle[1] + triangle[2]) / 2;
  const double in_the_middle = (values[1] + values[2]) / 2;
  for (const Vector2& at : places()) {
    const double parts = linear_potential({triangle[0], triangle[1], middle},
                                          {values[0], values[1], in_the_middle}, at) +
                         linear_potential({triangle[0], middle, triangle[2]},
                                          {values[0], in_the_middle, values[2]}, at);
    BOOST_TEST(std::abs(parts - linear_potential(triangle, values, at)) < 4e-15);
  }
}

BOOST_AUTO_TEST_CASE(the_middle_of_a_rectangle_is_displaced_as_love_says) {
  // Love 1929, Johnson 3.25 at the centre: 2a arsinh(b/a) + 2b arsinh(a/b), half sides a and b,
  // four times over two.
  const double a = 0.7;
  const double b = 2.385;
  const std::array<Vector2, 4> corners = {Vector2(-a, -b), Vector2(a, -b), Vector2(a, b),
                                          Vector2(-a, b)};
  const double love = 4 * (a * std::asinh(b / a) + b * std::asinh(a / b));

  BOOST_TEST(relative_difference(uniform_potential(corners, Vector2::Zero()), love) < 1e-15);
  // a corner has half of what four rectangles around a centre have, each twice as long and wide
  BOOST_TEST(relative_difference(uniform_potential(corners, corners[2]), love / 2) < 1e-15);
}

BOOST_AUTO_TEST_CASE(a_polygon_with_many_corners_is_a_disk) {
  // A uniform pressure on a disk of radius 1: 2π in the middle, 4 at the edge (Johnson 3.29).
  std::vector<Vector2> corners;
  constexpr int n = 4000;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n;
    corners.emplace_back(std::cos(angle), std::sin(angle));
  }
  BOOST_TEST(relative_difference(uniform_potential(corners, Vector2::Zero()),
                                 2 * std::numbers::pi) < 1e-6);
  BOOST_TEST(relative_difference(uniform_potential(corners, {1, 0}), 4) < 1e-5);
}

BOOST_AUTO_TEST_SUITE_END()
