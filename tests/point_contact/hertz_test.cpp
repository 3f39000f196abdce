// SPDX-License-Identifier: GPL-3.0-or-later
// The conditions of contact, for each closed form.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "numbers.hpp"
#include "numerics/quadrature.hpp"
#include "point_contact/cases.hpp"

BOOST_AUTO_TEST_SUITE(hertz_test)

using namespace point_cases;
using point_contact::Hertz;
using point_contact::HertzElliptic;
using point_contact::Vector2;
using std::numbers::pi;
using tolerance::relative_difference;

namespace {

struct ClosedForm {
  std::string name;
  double curvature_x, curvature_y;
  double a, b;  // semi-axes
  double peak_pressure, approach;
  std::function<double(const Vector2&)> pressure;

  double h(const Vector2& at) const {
    return (curvature_x * at.x() * at.x() + curvature_y * at.y() * at.y()) / 2;
  }
};

ClosedForm elliptic(const std::string& name, double along_x, double along_y) {
  const HertzElliptic contact(modulus, along_x, along_y, load);
  return {name,
          along_x,
          along_y,
          contact.semi_axis_x(),
          contact.semi_axis_y(),
          contact.peak_pressure(),
          contact.approach(),
          [=](const Vector2& at) { return contact.pressure(at); }};
}

const std::vector<ClosedForm> closed_forms{
    {"spheres", curvature, curvature, hertz.radius(), hertz.radius(), hertz.peak_pressure(),
     hertz.approach(), [](const Vector2& at) { return hertz.pressure(at.norm()); }},
    elliptic("spheres as ellipse", curvature, curvature),
    elliptic("ellipse", curvature_x, curvature_y),
    elliptic("long ellipse", 3.7, 0.002385)};

// (1/(πE*)) ∫ p dA/r at a point, by quadrature of chords: along each ray from the point the ellipse
// begins and ends where ρ solves a quadratic equation, and ∫ p dρ between has a closed form.
double displacement(const ClosedForm& c, const Vector2& at) {
  const Vector2 scaled(at.x() / c.a, at.y() / c.b);
  const auto along = [&](double angle) {
    const Vector2 e(std::cos(angle) / c.a, std::sin(angle) / c.b);
    // p² = p₀² (C − 2Bρ − Aρ²) with A = e·e, B = e·s, C = 1 − s·s
    const double A = e.squaredNorm(), B = e.dot(scaled), C = 1 - scaled.squaredNorm();
    const double square = B * B / (A * A) + C / A;  // half the chord, squared
    if (square <= 0) return 0.0;
    const double half = std::sqrt(square);
    const double middle = -B / A;
    if (C <= 0) return middle > 0 ? std::sqrt(A) * pi / 2 * square : 0.0;  // all of the chord
    const double t = -middle / half;                                       // from here on
    return std::sqrt(A) * square / 2 *
           (pi / 2 - std::asin(t) - t * std::sqrt(std::max(0.0, 1 - t * t)));
  };
  numerics::Quadrature quadrature(5000);
  double sum = 0;
  // Integrate in pieces, because the rays of a long ellipse crowd together.
  constexpr int n_pieces = 64;
  for (int k = 0; k < n_pieces; ++k) {
    sum += quadrature
               .adaptive(along, 2 * pi * k / n_pieces, 2 * pi * (k + 1) / n_pieces,
                         1e-12 * std::sqrt(c.a * c.b), {"chords", at.x()})
               .value;
  }
  return c.peak_pressure * sum / (pi * modulus);
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_pressure_is_ellipsoidal_and_carries_the_load) {
  for (const ClosedForm& c : closed_forms) {
    BOOST_TEST_CONTEXT(c.name) {
      BOOST_TEST(relative_difference(2 * pi / 3 * c.a * c.b * c.peak_pressure, load) < 1e-14);
      for (const auto& [xi, eta] : {std::pair{0.3, -0.7}, {0.0, 0.0}, {-0.9, 0.1}}) {
        const double p = c.peak_pressure * std::sqrt(1 - xi * xi - eta * eta);
        BOOST_TEST(relative_difference(c.pressure({xi * c.a, eta * c.b}), p) < 1e-14);
      }
      BOOST_TEST(c.pressure({c.a, 0}) == 0);
      BOOST_TEST(c.pressure({0.8 * c.a, -0.7 * c.b}) == 0);
    }
  }
}

BOOST_AUTO_TEST_CASE(the_pressure_closes_the_gap_by_equation_1a_and_opens_it_by_1b) {
  for (const ClosedForm& c : closed_forms) {
    const double scale = c.approach;
    for (const auto& [xi, eta] : {std::pair{0.0, 0.0}, {0.31, 0.2}, {-0.7, 0.6}, {0.0, -0.95}}) {
      const Vector2 at(xi * c.a, eta * c.b);
      BOOST_TEST_CONTEXT(c.name << ", inside at " << xi << ", " << eta) {
        BOOST_TEST(std::abs(displacement(c, at) + c.h(at) - c.approach) < 1e-9 * scale);
      }
    }
    for (const auto& [xi, eta] : {std::pair{1.1, 0.0}, {0.9, -0.9}, {0.2, 1.7}}) {
      const Vector2 at(xi * c.a, eta * c.b);
      BOOST_TEST_CONTEXT(c.name << ", outside at " << xi << ", " << eta) {
        BOOST_TEST(displacement(c, at) + c.h(at) > c.approach);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(spheres_match_johnson) {
  // Johnson 4.22–4.24 with R = 1/κ.
  const double R = 1 / curvature;
  BOOST_TEST(relative_difference(hertz.radius(), std::cbrt(3 * load * R / (4 * modulus))) < 1e-15);
  BOOST_TEST(relative_difference(hertz.approach(), hertz.radius() * hertz.radius() / R) < 1e-14);
  BOOST_TEST(relative_difference(hertz.peak_pressure(), std::cbrt(6 * load * modulus * modulus /
                                                                  (pi * pi * pi * R * R))) < 1e-14);
}

BOOST_AUTO_TEST_SUITE_END()
