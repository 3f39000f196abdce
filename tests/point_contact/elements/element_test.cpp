// SPDX-License-Identifier: GPL-3.0-or-later
// References are the formulas as they stand, in a hundred digits: of the fourth differences at 1e6
// spacings some twenty are left.
#include "point_contact/elements/element.hpp"

#include <algorithm>
#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "multiprecision.hpp"
#include "point_contact/polar_quadrature.hpp"
#include "random_inputs.hpp"
#include "system/require.hpp"
#include "tolerances.hpp"

BOOST_AUTO_TEST_SUITE(element_test)

using point_contact::cross;
using point_contact::Element;
using point_contact::ElementPotential;
using point_contact::hexagonal_lattice;
using point_contact::Lattice;
using point_contact::square_lattice;
using point_contact::Vector2;
using sys::InvalidQuantity;

namespace {

using PrecisePoint = std::array<Precise, 2>;

PrecisePoint precise(const Vector2& v) {
  return {Precise(v.x()), Precise(v.y())};
}

PrecisePoint minus(const PrecisePoint& a, const PrecisePoint& b) {
  return {a[0] - b[0], a[1] - b[1]};
}

// t arsinh(s/|t|), 0 at t = 0
Precise times_asinh(const Precise& t, const Precise& s) {
  return abs(t) < Precise("1e-45") ? Precise(0) : Precise(t * asinh(s / abs(t)));
}

// ∫ (1 at the first corner, 0 at the others) dA/r over a triangle, term by term.
Precise precise_triangle(const std::array<PrecisePoint, 3>& corners, const PrecisePoint& at) {
  Precise uniform = 0;
  PrecisePoint linear = {0, 0};
  for (std::size_t i = 0; i < 3; ++i) {
    const PrecisePoint side = minus(corners[(i + 1) % 3], corners[i]);
    const Precise length = sqrt(side[0] * side[0] + side[1] * side[1]);
    const PrecisePoint tangent = {side[0] / length, side[1] / length};
    const PrecisePoint d = minus(corners[i], at);
    const Precise h = d[0] * tangent[1] - d[1] * tangent[0];
    const Precise s1 = d[0] * tangent[0] + d[1] * tangent[1];
    const Precise s2 = s1 + length;
    const Precise angular = times_asinh(h, s2) - times_asinh(h, s1);
    const Precise moment =
        (s2 * sqrt(s2 * s2 + h * h) - s1 * sqrt(s1 * s1 + h * h) + h * angular) / 2;
    uniform += angular;
    linear[0] += tangent[1] * moment;
    linear[1] -= tangent[0] * moment;
  }
  const PrecisePoint a = minus(corners[1], corners[0]);
  const PrecisePoint b = minus(corners[2], corners[0]);
  const Precise area = a[0] * b[1] - a[1] * b[0];
  const PrecisePoint gradient = {(a[1] - b[1]) / area, (b[0] - a[0]) / area};
  const PrecisePoint d = minus(at, corners[0]);
  return (1 + gradient[0] * d[0] + gradient[1] * d[1]) * uniform + gradient[0] * linear[0] +
         gradient[1] * linear[1];
}

Precise precise_pyramid(const Lattice& lattice, const PrecisePoint& at) {
  const PrecisePoint a = precise(lattice.first);
  const PrecisePoint b = precise(lattice.second);
  const PrecisePoint c = minus(b, a);
  const auto opposite = [](const PrecisePoint& p) { return PrecisePoint{-p[0], -p[1]}; };
  const std::array<PrecisePoint, 6> ring = {a, b, c, opposite(a), opposite(b), opposite(c)};
  Precise sum = 0;
  for (std::size_t i = 0; i < 6; ++i) {
    sum += precise_triangle({PrecisePoint{0, 0}, ring[i], ring[(i + 1) % 6]}, at);
  }
  return sum;
}

// F with ∂²/∂x² ∂²/∂y² F = 1/r, and G with ∂²/∂x∂y G = 1/r.
Precise fourth_integral(const Precise& x, const Precise& y) {
  const Precise r = sqrt(x * x + y * y);
  return (x * y * times_asinh(x, y) + x * y * times_asinh(y, x)) / 2 - r * r * r / 6;
}
Precise second_integral(const Precise& x, const Precise& y) {
  return times_asinh(x, y) + times_asinh(y, x);
}

Precise precise_bilinear(const Lattice& lattice, const PrecisePoint& at) {
  const Precise a = lattice.first.x();
  const Precise b = lattice.second.y();
  constexpr std::array<int, 3> weights = {1, -2, 1};
  Precise sum = 0;
  for (int i = -1; i <= 1; ++i) {
    for (int j = -1; j <= 1; ++j) {
      sum += weights[static_cast<std::size_t>(i + 1)] * weights[static_cast<std::size_t>(j + 1)] *
             fourth_integral(at[0] + i * a, at[1] + j * b);
    }
  }
  return sum / (a * b);
}

Precise precise_uniform(const Lattice& lattice, const PrecisePoint& at) {
  const Precise a = Precise(lattice.first.x()) / 2;
  const Precise b = Precise(lattice.second.y()) / 2;
  return second_integral(at[0] + a, at[1] + b) - second_integral(at[0] + a, at[1] - b) -
         second_integral(at[0] - a, at[1] + b) + second_integral(at[0] - a, at[1] - b);
}

Precise precise_potential(Element element, const Lattice& lattice, const Vector2& d) {
  switch (element) {
    case Element::uniform:
      return precise_uniform(lattice, precise(d));
    case Element::bilinear:
      return precise_bilinear(lattice, precise(d));
    default:
      return precise_pyramid(lattice, precise(d));
  }
}

struct Case {
  Element element;
  Lattice lattice;
  double tolerance;  // of T(0)
};

// As wide as long, and five and ten times as long as wide.
std::vector<Case> cases() {
  std::vector<Case> all;
  for (const double stretch : {1.0, 0.2, 0.1}) {
    Lattice hexagonal = hexagonal_lattice(1);
    hexagonal.second.y() *= stretch;
    const Lattice rectangular{{1, 0}, {0, stretch}};
    all.push_back({Element::uniform, rectangular, 1e-14});
    all.push_back({Element::bilinear, rectangular, 1e-14});
    all.push_back({Element::pyramid, hexagonal, stretch == 1 ? 1e-14 : 1e-13});
  }
  return all;
}

// Nodes, edges, corners, points between and far away.
std::vector<Vector2> places(const ElementPotential& potential) {
  std::vector<Vector2> all;
  for (int i = 0; i <= 9; ++i) {
    for (int j = -3; j <= 9; ++j) all.push_back(potential.node(i, j));
  }
  for (const double i : {0.5, 1.0, 0.25}) all.push_back(potential.node(i, 0.5));
  RandomInputs random(2385);
  for (int i = 0; i < 60; ++i) {
    all.push_back(potential.node(random.uniform(-4, 4), random.uniform(-4, 4)));
    const double r = random.log_uniform(4, 1e6);
    const double angle = random.uniform(-3.2, 3.2);
    all.emplace_back(r * std::cos(angle), r * std::sin(angle));
  }
  return all;
}

}  // namespace

BOOST_AUTO_TEST_CASE(influence_coefficients_are_right_to_1e_13_of_the_largest_at_all_distances) {
  for (const Case& one : cases()) {
    const ElementPotential potential(one.element, one.lattice);
    const Lattice lattice = one.lattice.normalised();
    const double largest = potential(Vector2::Zero());
    double worst = 0;
    for (const Vector2& d : places(potential)) {
      const Precise exact = precise_potential(one.element, lattice, d);
      worst = std::max(worst, static_cast<double>(abs(potential(d) - exact)) / largest);
    }
    BOOST_TEST(worst < one.tolerance, name_of(one.element) << ": " << worst);
  }
}

BOOST_AUTO_TEST_CASE(far_away_they_are_right_to_2e_15_of_themselves) {
  RandomInputs random(17);
  for (const Case& one : cases()) {
    const ElementPotential potential(one.element, one.lattice);
    const Lattice lattice = one.lattice.normalised();
    for (int i = 0; i < 100; ++i) {
      const double r = random.log_uniform(12, 1e6);
      const double angle = random.uniform(-3.2, 3.2);
      const Vector2 d(r * std::cos(angle), r * std::sin(angle));
      const Precise exact = precise_potential(one.element, lattice, d);
      BOOST_TEST_CONTEXT(name_of(one.element) << " at " << d.transpose()) {
        BOOST_TEST(static_cast<double>(abs(potential(d) / exact - 1)) < 2e-15);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(known_values_of_the_middle_are_met) {
  // mpmath 1.2.1, 40 digits, of the same formulas: square and equilateral cells of area 1.
  const ElementPotential uniform(Element::uniform, square_lattice(1));
  const ElementPotential bilinear(Element::bilinear, square_lattice(1));
  const ElementPotential pyramid(Element::pyramid, hexagonal_lattice(1));

  BOOST_TEST(std::abs(uniform(Vector2::Zero()) - 3.5254943480781721009) < 1e-15);
  BOOST_TEST(std::abs(bilinear(Vector2::Zero()) - 2.9732095982473787025) < 1e-15);
  BOOST_TEST(std::abs(pyramid(Vector2::Zero()) - 3.0671218023114642067) < 1e-15);
}

BOOST_AUTO_TEST_CASE(an_element_displaces_as_the_quadrature_of_boussinesqs_integral_says) {
  const Lattice square = square_lattice(1);
  const auto hat = [](const Vector2& s) {
    return std::max(0.0, 1 - std::abs(s.x())) * std::max(0.0, 1 - std::abs(s.y()));
  };
  std::vector<std::pair<Vector2, Vector2>> lines_of_hat;
  for (const double t : {-1, 0, 1}) {
    lines_of_hat.push_back({{-1, t}, {1, t}});
    lines_of_hat.push_back({{t, -1}, {t, 1}});
  }
  const Lattice hexagonal = hexagonal_lattice(1).normalised();
  const Vector2 a = hexagonal.first;
  const Vector2 b = hexagonal.second;
  const auto pyramid = [&](const Vector2& s) {
    // the three distances from the middle to the hexagon's sides
    const double i = cross(s, b) / cross(a, b);
    const double j = cross(a, s) / cross(a, b);
    return std::max(0.0, 1 - std::max({std::abs(i), std::abs(j), std::abs(i + j)}));
  };
  const std::array<Vector2, 6> ring = {a, b, b - a, -a, -b, a - b};
  std::vector<std::pair<Vector2, Vector2>> lines_of_pyramid;
  for (std::size_t i = 0; i < 6; ++i) {
    lines_of_pyramid.emplace_back(ring[i], ring[(i + 1) % 6]);
    lines_of_pyramid.emplace_back(Vector2::Zero(), ring[i]);
  }
  const ElementPotential of_hat(Element::bilinear, square);
  const ElementPotential of_pyramid(Element::pyramid, hexagonal);
  for (const Vector2& at :
       {Vector2(0, 0), Vector2(1, 0), Vector2(0.4, 0.3), Vector2(2.385, -0.7)}) {
    BOOST_TEST(std::abs(of_hat(at) - polar_potential(hat, lines_of_hat, at)) < 1e-8);
    BOOST_TEST(std::abs(of_pyramid(at) - polar_potential(pyramid, lines_of_pyramid, at)) < 1e-8);
  }
}

BOOST_AUTO_TEST_CASE(the_series_continues_the_closed_form) {
  for (const Case& one : cases()) {
    const ElementPotential potential(one.element, one.lattice);
    const double begin = 3 * std::max(one.lattice.normalised().first.norm(), 1.0);
    for (const double angle : {0.1, 0.9, 2.2}) {
      double step = 0;
      double previous = 0;
      for (double r = begin - 0.7; r < begin + 3; r += 1e-3) {
        const Vector2 d(r * std::cos(angle), r * std::sin(angle));
        const double scaled = potential(d) * r;
        // r T(d) changes slowly: no step is much greater than the one before it
        if (previous != 0) step = std::max(step, std::abs(scaled - previous));
        previous = scaled;
      }
      BOOST_TEST(step < 1e-4);
    }
  }
}

BOOST_AUTO_TEST_CASE(potentials_are_even_and_have_the_symmetry_of_the_lattice) {
  const ElementPotential pyramid(Element::pyramid, hexagonal_lattice(0.3));
  const ElementPotential bilinear(Element::bilinear, square_lattice(0.3));
  for (const double scale : {1.0, 7.0, 300.0}) {
    const double here = pyramid(pyramid.node(2 * scale, scale));
    BOOST_TEST(tolerance::relative_difference(pyramid(pyramid.node(-2 * scale, -scale)), here) <
               1e-12);
    // a turn by 60° takes (i, j) to (−j, i + j)
    BOOST_TEST(tolerance::relative_difference(pyramid(pyramid.node(-scale, 3 * scale)), here) <
               1e-12);
    BOOST_TEST(tolerance::relative_difference(bilinear(bilinear.node(2 * scale, scale)),
                                              bilinear(bilinear.node(-scale, 2 * scale))) < 1e-12);
  }
}

BOOST_AUTO_TEST_CASE(the_sense_of_the_lattice_does_not_matter) {
  const Lattice lattice = hexagonal_lattice(1);
  const ElementPotential one(Element::pyramid, lattice);
  const ElementPotential other(Element::pyramid, {lattice.second, lattice.first});
  const ElementPotential flat(Element::uniform, lattice);
  const ElementPotential turned(Element::uniform, {lattice.second, lattice.first});
  for (const double i : {0.0, 0.4, 2.0}) {
    BOOST_TEST(std::abs(one(one.node(i, 1)) - other(other.node(1, i))) < 1e-14);
    BOOST_TEST(std::abs(flat(flat.node(i, 1)) - turned(turned.node(1, i))) < 1e-14);
  }
}

BOOST_AUTO_TEST_CASE(the_force_on_its_own_node_is_the_lattice_sum) {
  // −Σ′ 1/|d| regularised: 4 ζ(1/2) β(1/2) for squares, mpmath 1.2.1:
  // -4*zeta(0.5)*dirichlet(0.5,[0,1,0,-1])
  const ElementPotential force(Element::point, square_lattice(2.385));

  BOOST_TEST(tolerance::relative_difference(force(Vector2::Zero()), 3.9002649200019558828) < 1e-14);
  BOOST_TEST(force(force.node(3, 4)) == 0.2);
}

BOOST_AUTO_TEST_CASE(elements_on_a_lattice_stand_for_a_smooth_pressure_to_their_order) {
  // (1 − r²)³ on the disk: by forces to order 3, by the others to order 2.
  const auto pressure = [](double r) { return r < 1 ? std::pow(1 - r * r, 3) : 0; };
  const double rho = 0.2385;
  const double exact = axial_potential(pressure, 1, rho);
  const auto error = [&](Element element, const Lattice& lattice) {
    const ElementPotential potential(element, lattice);
    const double c = std::sqrt(lattice.cell_area());
    double sum = 0;
    const int n = static_cast<int>(3 / c);
    for (int i = -n; i <= n; ++i) {
      for (int j = -n; j <= n; ++j) {
        const Vector2 s = Vector2(rho, 0) + i * lattice.first + j * lattice.second;
        sum += c * potential(potential.node(i, j)) * pressure(s.norm());
      }
    }
    return std::abs(sum - exact);
  };
  const auto order = [&](Element element, const Lattice& coarse) {
    const Lattice fine{coarse.first / 2, coarse.second / 2};
    return std::log2(error(element, coarse) / error(element, fine));
  };
  BOOST_TEST(order(Element::point, square_lattice(0.05)) > 2.8);
  BOOST_TEST(std::abs(order(Element::uniform, square_lattice(0.05)) - 2) < 0.1);
  BOOST_TEST(std::abs(order(Element::bilinear, square_lattice(0.05)) - 2) < 0.1);
  BOOST_TEST(std::abs(order(Element::pyramid, hexagonal_lattice(0.05)) - 2) < 0.1);
}

BOOST_AUTO_TEST_CASE(bad_lattices_are_refused) {
  BOOST_CHECK_THROW(ElementPotential(Element::uniform, {{1, 0}, {2, 0}}), InvalidQuantity);
  BOOST_CHECK_THROW(ElementPotential(Element::uniform, {{std::nan(""), 0}, {0, 1}}),
                    InvalidQuantity);
  BOOST_CHECK_THROW(ElementPotential(Element::bilinear, hexagonal_lattice(1)), InvalidQuantity);
  BOOST_CHECK_THROW(square_lattice(0), InvalidQuantity);
  BOOST_CHECK_THROW(hexagonal_lattice(-1), InvalidQuantity);
}

BOOST_AUTO_TEST_CASE(elements_have_names) {
  BOOST_TEST(name_of(Element::point) == "point");
  BOOST_TEST(name_of(Element::uniform) == "uniform");
  BOOST_TEST(name_of(Element::bilinear) == "bilinear");
  BOOST_TEST(name_of(Element::pyramid) == "pyramid");
}

BOOST_AUTO_TEST_SUITE_END()
