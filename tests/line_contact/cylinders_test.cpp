// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_contact/cylinders.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "elasticity/surface_quadrature.hpp"
#include "multiprecision.hpp"
#include "numbers.hpp"
#include "numerics/quadrature.hpp"

BOOST_AUTO_TEST_SUITE(cylinders_test)

using elasticity::Material;
using elasticity::Stress;
using line_contact::CylinderPair;
using line_contact::Hertz;
using line_contact::McEwen;
using line_contact::Radius;
using std::numbers::pi;
using tolerance::relative_difference;

namespace {

const Material steel(30e6, 0.3);
const Material rubber(700, 0.48);
// A cylinder in a hollow.
const CylinderPair cylinders(steel, Radius::of_cylinder("radius1", 1), rubber,
                             Radius::of_cylinder("radius2", -2.385));
const Hertz hertz(cylinders, 3.5);
const McEwen mcewen(hertz);
const double a = hertz.half_width();
const double p0 = hertz.peak_pressure();

// Both bodies under Hertz's pressure, by quadrature.
struct Bodies {
  explicit Bodies(double datum)
      : body1(steel, pressure(), datum), body2(rubber, pressure(), datum) {}
  static elasticity::Load pressure() {
    return elasticity::distributed_load([](double x) { return hertz.pressure(x); }, {-a, a});
  }
  double slope(double x) const {
    return body1.normal_gradient(x).value + body2.normal_gradient(x).value;
  }
  double displacement(double x) const {
    return body1.normal_displacement(x).value + body2.normal_displacement(x).value;
  }
  elasticity::SurfaceQuadrature body1, body2;
};

double distance(const Stress& s, const Stress& t) {
  return std::max({std::abs(s.xx - t.xx), std::abs(s.zz - t.zz), std::abs(s.xz - t.xz)});
}

double relative_error(double value, const Precise& exact) {
  return exact == 0 ? std::abs(value) : abs((value - exact) / exact).toDouble();
}

}  // namespace

BOOST_AUTO_TEST_CASE(curvatures_and_compliances_of_the_two_bodies_add) {
  BOOST_TEST(relative_difference(cylinders.relative_curvature(), 1 - 1 / 2.385) < 1e-15);
  const CylinderPair on_plane(steel, Radius::of_cylinder("radius1", 0.5), steel,
                              Radius::of_plane());
  BOOST_TEST(on_plane.relative_curvature() == 2);
  BOOST_TEST(on_plane.profile().gap(-0.5) == 0.25);
  BOOST_TEST(cylinders.contact_modulus() == elasticity::contact_modulus(steel, rubber));
}

BOOST_AUTO_TEST_CASE(the_papers_cylinders_have_their_half_width_and_peak) {
  // a = √(4PR/(πE*)), p₀ = 2P/(πa) with P = 2500 lbf/in, R = 3/4 in, E* = 30e6/(2·0.91) psi.
  const Hertz contact(CylinderPair(steel, Radius::of_cylinder("radius1", 1), steel,
                                   Radius::of_cylinder("radius2", 3)),
                      2500);
  BOOST_TEST(std::abs(contact.half_width() - 0.012035) < 0.5e-6);
  BOOST_TEST(std::abs(contact.peak_pressure() - 132248) < 0.5);
}

BOOST_AUTO_TEST_CASE(the_pressure_carries_the_load_and_is_zero_beyond_the_edge) {
  BOOST_TEST(relative_difference(numerics::KernelIntegrals(Bodies::pressure().normal).total().value,
                                 3.5) < 1e-10);
  BOOST_TEST(hertz.pressure(0) == p0);
  BOOST_TEST(hertz.pressure(a) == 0);
  BOOST_TEST(hertz.pressure(-2 * a) == 0);
  // At the distance t from the edge the pressure is p₀ √(2t/a), with all digits of t
  const double inside = std::nextafter(a, 0);
  BOOST_TEST(relative_difference(hertz.pressure(-inside), p0 * std::sqrt(2 * (a - inside) / a)) <
             1e-14);
}

BOOST_AUTO_TEST_CASE(the_pressure_closes_the_gap_by_equation_1a_and_opens_it_by_1b) {
  const Bodies bodies(100);
  for (const double share : {-0.95, -0.3, 0.123, 0.8}) {
    const double x = share * a;
    BOOST_TEST(relative_difference(bodies.slope(x), -cylinders.relative_curvature() * x) < 1e-9);
  }
  const auto sum = [&](double x) { return bodies.displacement(x) + cylinders.profile().gap(x); };
  for (const double share : {1.01, 1.5, -3.0, 12.0}) {
    BOOST_TEST(sum(share * a) > sum(a));
  }
}

BOOST_AUTO_TEST_CASE(the_approach_is_the_sum_of_both_displacements_in_the_middle) {
  // Eq. (1a) at x = 0, where h = 0.
  for (const double share : {1.0001, 1.7, -12.0, 2385.0}) {
    BOOST_TEST(relative_difference(hertz.approach(share * a), Bodies(share * a).displacement(0)) <
               1e-9);
  }
  for (const double share : {0.0, -0.385, 1.0}) {  // in contact it is the gap
    BOOST_TEST(std::abs(hertz.approach(share * a) - cylinders.profile().gap(share * a)) <
               1e-15 * cylinders.profile().gap(a));
  }
}

BOOST_AUTO_TEST_CASE(mcewens_stresses_are_accurate_to_2e_15_from_the_surface_to_1e6_half_widths) {
  // Johnson (4.49a–c) unchanged, in 100 digits: far away near the surface it loses forty.
  RandomInputs random(61);
  for (int i = 0; i < 4000; ++i) {
    const double from = i % 3 == 0 ? 0 : a * random.sign();
    const double x_ = i % 20 == 0 ? 0 : from + random.sign() * a * random.log_uniform(1e-9, 1e6);
    const double z_ = a * random.log_uniform(1e-9, 1e6);
    const Precise x = x_;
    const Precise z = z_;
    const Precise A = a;
    const Precise s = A * A - x * x + z * z;
    const Precise root = sqrt(s * s + 4 * x * x * z * z);
    const Precise m = sqrt((root + s) / 2);
    const Precise n = (x < 0 ? -1 : 1) * sqrt((root - s) / 2);
    const Precise share = (z * z + n * n) / (m * m + n * n);
    const Precise third = (m * m - z * z) / (m * m + n * n);

    const Stress stress = mcewen.stress(x_, z_);

    BOOST_TEST_CONTEXT("x/a = " << x_ / a << ", z/a = " << z_ / a) {
      BOOST_TEST(relative_error(stress.xx, -p0 / A * (m * (1 + share) - 2 * z)) < 2e-15);
      BOOST_TEST(relative_error(stress.zz, -p0 / A * m * (1 - share)) < 2e-15);
      BOOST_TEST(relative_error(stress.xz, -p0 / A * n * third) < 2e-15);
    }
  }
}

BOOST_AUTO_TEST_CASE(mcewens_stresses_agree_with_the_quadrature_of_line_forces) {
  // Johnson (2.23) with s = a sin φ, which removes the root from the pressure.
  numerics::Quadrature quadrature;
  for (const auto& point : {std::pair{0.3, 0.4}, {-0.8, 0.15}, {1.0, 0.385}, {0.0, 5.0}}) {
    const double x = point.first, z = point.second;
    const auto integral = [&](int power) {
      const auto force = [&](double angle) {
        const double t = x - std::sin(angle);
        return -2 / pi * p0 * std::pow(std::cos(angle), 2) * std::pow(t, power) *
               std::pow(z, 3 - power) / std::pow(t * t + z * z, 2);
      };
      return quadrature.adaptive(force, -pi / 2, pi / 2, 1e-13 * p0, {"line forces", x}).value;
    };
    BOOST_TEST(distance(mcewen.stress(x * a, z * a), {integral(2), integral(0), integral(1)}) <
               1e-12 * p0);
  }
}

BOOST_AUTO_TEST_CASE(mcewens_stresses_are_the_pressure_on_the_surface_and_zero_at_the_edges) {
  for (const double share : {-0.97, 0.0, 0.123, 0.999999, 1.0, 1.3, -40.0}) {
    const Stress surface = mcewen.stress(share * a, 0);
    const double rounding = 1e-13 * p0;  // of 1 − x²/a² in the pressure, beside the edge
    BOOST_TEST(distance(surface, {-hertz.pressure(share * a), -hertz.pressure(share * a), 0}) <
               rounding);
  }
}

BOOST_AUTO_TEST_SUITE_END()
