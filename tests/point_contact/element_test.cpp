// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/element.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <vector>

#include "multiprecision.hpp"
#include "numbers.hpp"
#include "numerics/quadrature.hpp"

BOOST_AUTO_TEST_SUITE(element_test)

using point_contact::Element;
using point_contact::influence_coefficient;
using point_contact::Vector2;

namespace {

// ∫ dA/r over a unit square in 100 digits: the mixed difference of x asinh(y/x) + y asinh(x/y).
Precise precise_uniform(const Precise& x, const Precise& y) {
  const auto corner = [](const Precise& a, const Precise& b) {
    Precise sum = 0;
    if (a != 0) sum += a * asinh(b / abs(a));
    if (b != 0) sum += b * asinh(a / abs(b));
    return sum;
  };
  const Precise half = Precise(1) / 2;
  return corner(x + half, y + half) - corner(x - half, y + half) - corner(x + half, y - half) +
         corner(x - half, y - half);
}

// A pyramid is a uniform square smeared along (−1, 1). Near the diagonal through d the
// integrand has kinks like t ln t where an edge passes.
double smeared(const Vector2& d) {
  numerics::Quadrature quadrature;
  std::vector<double> ends = {-0.5, 0.5};
  for (const double edge : {-0.5, 0.5}) {
    for (const double t : {edge - d.x(), d.y() - edge}) {
      if (std::abs(t) < 0.5) ends.push_back(t);
    }
  }
  std::sort(ends.begin(), ends.end());
  double sum = 0;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    if (ends[i] == ends[i + 1]) continue;
    const auto uniform = [&](double t) {
      return precise_uniform(Precise(d.x()) + t, Precise(d.y()) - t).toDouble();
    };
    sum += quadrature.adaptive(uniform, ends[i], ends[i + 1], 1e-14, {"pyramid", d.x()}).value;
  }
  return sum;
}

// Nodes and other points nearby, at the changes of rule at 7, 20, 60, 120 spacings, and far away.
std::vector<Vector2> places() {
  std::vector<Vector2> result;
  for (int i = -5; i <= 5; ++i) {
    for (int j = 0; j <= 5; ++j) result.emplace_back(i, j);
  }
  RandomInputs random(7);
  for (const double r :
       {0.3, 1.0, 4.0, 6.99, 7.01, 19.9, 20.1, 59.9, 60.1, 119.0, 121.0, 1e3, 1e5}) {
    for (int i = 0; i < 6; ++i) {
      const double angle = random.uniform(0, 2 * std::numbers::pi);
      result.emplace_back(r * std::cos(angle), r * std::sin(angle));
    }
  }
  return result;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_uniform_element_is_accurate_to_1e_14_near_and_2e_14_relative_far_away) {
  for (const Vector2& d : places()) {
    const Precise exact = precise_uniform(d.x(), d.y());
    const double error = abs(influence_coefficient(Element::uniform, d) - exact).toDouble();
    BOOST_TEST_CONTEXT("d = (" << d.x() << ", " << d.y() << ")") {
      BOOST_TEST(error < 2e-14 * (d.norm() < 7 ? 3.5 : exact.toDouble()));
    }
  }
}

BOOST_AUTO_TEST_CASE(a_pyramid_is_a_smeared_uniform_element) {
  for (const Vector2& d : places()) {
    const double exact = smeared(d);
    BOOST_TEST_CONTEXT("d = (" << d.x() << ", " << d.y() << ")") {
      BOOST_TEST(std::abs(influence_coefficient(Element::pyramid, d) - exact) <
                 (d.norm() < 7 ? 2e-13 : 3e-14 * exact));
    }
  }
}

BOOST_AUTO_TEST_CASE(elements_are_even_and_symmetric_in_x_and_y) {
  for (const Element element : {Element::uniform, Element::pyramid}) {
    for (const Vector2& d : places()) {
      const double value = influence_coefficient(element, d);
      for (const Vector2& other : {Vector2(-d), Vector2(d.y(), d.x()), Vector2(-d.y(), -d.x())}) {
        BOOST_TEST(std::abs(influence_coefficient(element, other) - value) < 1e-14);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(far_away_an_element_acts_as_a_force) {
  for (const Element element : {Element::uniform, Element::pyramid}) {
    const Vector2 d(3e5, -4e5);
    BOOST_TEST(tolerance::relative_difference(influence_coefficient(element, d), 2e-6) < 1e-11);
  }
}

BOOST_AUTO_TEST_CASE(a_linear_pressure_on_a_triangle_agrees_with_quadrature) {
  // In polar coordinates about a corner of the triangle (0, 0), (1, 0), (0.3, 0.8): ∫∫ σ dρ dθ.
  const std::array<Vector2, 3> corners = {{{0, 0}, {1, 0}, {0.3, 0.8}}};
  const std::array<double, 3> values = {0.7, -0.2, 1.3};
  numerics::Quadrature quadrature;
  const auto at_angle = [&](double angle) {
    const Vector2 e(std::cos(angle), std::sin(angle));
    const Vector2 side = corners[2] - corners[1];
    const double rho = point_contact::cross(corners[1], side) / point_contact::cross(e, side);
    // σ is linear along the ray: half the sum of its ends
    const double share = (rho * e - corners[1]).norm() / side.norm();
    return rho * (values[0] + values[1] + share * (values[2] - values[1])) / 2;
  };
  const double exact =
      quadrature.smooth(at_angle, 0, std::atan2(0.8, 0.3), 1e-14, {"triangle", 0}).value;
  BOOST_TEST(std::abs(point_contact::linear_potential(corners, values, corners[0]) - exact) <
             1e-14);
}

BOOST_AUTO_TEST_SUITE_END()
