// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_contact/sliding_hertz.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "line_contact/mcewen.hpp"
#include "numerics/quadrature.hpp"
#include "random_inputs.hpp"
#include "system/require.hpp"

BOOST_AUTO_TEST_SUITE(sliding_hertz_test)

using elasticity::Material;
using elasticity::Stress;
using line_contact::CylinderPair;
using line_contact::Hertz;
using line_contact::Radius;
using line_contact::SlidingHertz;
using std::numbers::pi;
using sys::InvalidQuantity;

namespace {

const Material steel(30e6, 0.3);
const Material rubber(700, 0.48);
const Hertz hertz(CylinderPair(steel, Radius::of_cylinder("radius1", 1), rubber,
                               Radius::of_cylinder("radius2", -2.385)),
                  3.5);
const double a = hertz.half_width();
const double p0 = hertz.peak_pressure();
constexpr double friction = 0.4173;

double distance(const Stress& s, const Stress& t) {
  return std::max({std::abs(s.xx - t.xx), std::abs(s.zz - t.zz), std::abs(s.xz - t.xz)});
}

}  // namespace

BOOST_AUTO_TEST_CASE(without_friction_it_is_mcewen_to_its_stated_accuracy) {
  RandomInputs random(71);
  for (int i = 0; i < 2000; ++i) {
    const double x = random.sign() * a * random.log_uniform(1e-9, 1e3);
    const double z = a * random.log_uniform(1e-9, 1e3);
    const double reach = 1 + std::hypot(x, z) / a;

    BOOST_TEST(distance(SlidingHertz(hertz, 0).stress(x, z),
                        line_contact::McEwen(hertz).stress(x, z)) < 1e-14 * p0 * reach * reach);
  }
}

BOOST_AUTO_TEST_CASE(it_is_the_quadrature_of_line_forces_over_pressure_and_shear) {
  // Johnson (2.23) with s = a sin φ, which takes the root out of the tractions.
  numerics::Quadrature quadrature;
  struct Point {
    double x, z;  // in units of a
  };
  for (const Point& at : {Point{0.3, 0.4}, {-0.8, 0.15}, {1.0, 0.385}, {-2.385, 1.7}, {0, 5}}) {
    const double x = at.x;
    const double z = at.z;
    const auto integral = [&](int power) {  // of t^power z^(3−power)
      const auto force = [&](double angle) {
        const double t = x - std::sin(angle);
        const double pressure = p0 * std::pow(std::cos(angle), 2);
        return -2 / pi * pressure * std::pow(t, power) * std::pow(z, 3 - power) /
               std::pow(t * t + z * z, 2);
      };
      return quadrature.adaptive(force, -pi / 2, pi / 2, 1e-13 * p0, {"line forces", x}).value;
    };
    const Stress expected{integral(2) + friction * integral(3),
                          integral(0) + friction * integral(1),
                          integral(1) + friction * integral(2)};

    BOOST_TEST(distance(SlidingHertz(hertz, friction).stress(x * a, z * a), expected) < 1e-12 * p0);
  }
}

BOOST_AUTO_TEST_CASE(at_the_surface_the_stresses_are_the_tractions_and_johnsons_pull) {
  // Johnson, section 7.1: under the shear σ_xx = −2μp₀x/a in contact, which pulls behind the
  // middle.
  for (const double share : {-0.97, -0.385, 0.123, 0.8}) {
    const double x = share * a;
    const double p = hertz.pressure(x);
    const Stress surface = SlidingHertz(hertz, friction).stress(x, 1e-13 * a);

    BOOST_TEST(distance(surface, {-p - 2 * friction * p0 * share, -p, -friction * p}) < 1e-12 * p0);
  }
}

BOOST_AUTO_TEST_CASE(depths_that_are_not_in_the_body_are_refused) {
  const SlidingHertz sliding(hertz, friction);
  BOOST_CHECK_THROW(sliding.stress(0, 0), InvalidQuantity);
  BOOST_CHECK_THROW(sliding.stress(0, -1), InvalidQuantity);
  BOOST_CHECK_THROW(sliding.stress(NAN, 1), InvalidQuantity);
  BOOST_CHECK_THROW(SlidingHertz(hertz, std::numeric_limits<double>::infinity()), InvalidQuantity);
}

BOOST_AUTO_TEST_SUITE_END()
