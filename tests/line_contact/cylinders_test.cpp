// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_contact/cylinders.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "elasticity/interior_stress.hpp"
#include "elasticity/surface_quadrature.hpp"
#include "multiprecision.hpp"
#include "numerics/quadrature.hpp"
#include "random_inputs.hpp"
#include "system/require.hpp"
#include "tolerances.hpp"

BOOST_AUTO_TEST_SUITE(cylinders_test)

BOOST_AUTO_TEST_SUITE(cylinder_pair)

using elasticity::Material;
using line_contact::CylinderPair;
using line_contact::Radius;
using sys::InvalidQuantity;

namespace {

const Material steel(30e6, 0.3);

CylinderPair pair(double radius1, double radius2) {
  return {steel, Radius::of_cylinder("radius1", radius1), steel,
          Radius::of_cylinder("radius2", radius2)};
}

}  // namespace

BOOST_AUTO_TEST_CASE(curvatures_add) {
  BOOST_TEST(tolerance::relative_difference(pair(1, 3).relative_curvature(), 4.0 / 3) < 1e-15);
}

BOOST_AUTO_TEST_CASE(a_hollow_takes_curvature_away) {
  BOOST_TEST(tolerance::relative_difference(pair(1, -3).relative_curvature(), 2.0 / 3) < 1e-15);
}

BOOST_AUTO_TEST_CASE(a_plane_has_no_curvature) {
  const CylinderPair on_plane(steel, Radius::of_cylinder("radius1", 0.5), steel,
                              Radius::of_plane());

  BOOST_TEST(on_plane.relative_curvature() == 2);
}

BOOST_AUTO_TEST_CASE(the_gap_before_deformation_is_a_parabola) {
  BOOST_TEST(pair(1, -2).profile().gap(0.5) == 0.0625);
  BOOST_TEST(pair(1, -2).profile().gap(-0.5) == 0.0625);
}

BOOST_AUTO_TEST_CASE(the_profile_rises_with_the_relative_curvature_on_both_sides) {
  const CylinderPair cylinders = pair(2.385, 0.7);
  const double rise = cylinders.relative_curvature() / 2 * (0.31 * 0.31 - 0.3 * 0.3);

  BOOST_TEST(tolerance::relative_difference(cylinders.profile().rise(0.3, 0.31), rise) < 1e-13);
  BOOST_TEST(tolerance::relative_difference(cylinders.profile().rise(-0.3, -0.31), rise) < 1e-13);
  BOOST_TEST(cylinders.profile().is_symmetric());
}

BOOST_AUTO_TEST_CASE(the_modulus_is_that_of_both_materials) {
  const Material rubber(700, 0.48);
  const CylinderPair unlike(steel, Radius::of_plane(), rubber,
                            Radius::of_cylinder("radius2", 2.385));

  BOOST_TEST(unlike.contact_modulus() == elasticity::contact_modulus(steel, rubber));
}

BOOST_AUTO_TEST_CASE(bodies_that_do_not_touch_at_a_point_are_refused) {
  BOOST_CHECK_THROW(pair(1, -1), InvalidQuantity);
  BOOST_CHECK_THROW(pair(2, -1), InvalidQuantity);
  BOOST_CHECK_THROW(CylinderPair(steel, Radius::of_plane(), steel, Radius::of_plane()),
                    InvalidQuantity);
}

BOOST_AUTO_TEST_CASE(a_radius_of_zero_or_infinity_is_refused_by_its_name) {
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double radius : {0.0, infinity, double(NAN)}) {
    BOOST_CHECK_EXCEPTION(Radius::of_cylinder("radius2", radius), InvalidQuantity,
                          [](const InvalidQuantity& e) { return e.quantity() == "radius2"; });
  }
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(hertz)

using elasticity::Material;
using line_contact::CylinderPair;
using line_contact::Hertz;
using line_contact::Radius;
using sys::InvalidQuantity;

namespace {

const Material steel(30e6, 0.3);
const Material rubber(700, 0.48);
const CylinderPair cylinders(steel, Radius::of_cylinder("radius1", 1), rubber,
                             Radius::of_cylinder("radius2", -2.385));
const Hertz hertz(cylinders, 3.5);

elasticity::Load hertz_load() {
  const double a = hertz.half_width();
  return elasticity::distributed_load([](double x) { return hertz.pressure(x); }, nullptr, {-a, a});
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_papers_cylinders_have_their_half_width_and_peak) {
  // a = √(4PR/(πE*)), p₀ = 2P/(πa) with P = 2500 lbf/in, R = 3/4 in, E* = 30e6/(2·0.91) psi.
  const CylinderPair paper(steel, Radius::of_cylinder("radius1", 1), steel,
                           Radius::of_cylinder("radius2", 3));
  const Hertz contact(paper, 2500);

  BOOST_TEST(std::abs(contact.half_width() - 0.012035) < 0.5e-6);
  BOOST_TEST(std::abs(contact.peak_pressure() - 132248) < 0.5);
}

BOOST_AUTO_TEST_CASE(pressure_integrates_to_the_load) {
  const numerics::KernelIntegrals integrals(hertz_load().normal);

  BOOST_TEST(tolerance::relative_difference(integrals.total().value, 3.5) < 1e-10);
}

BOOST_AUTO_TEST_CASE(pressure_closes_the_gap_by_equation_1a) {
  // d/dx (u_z1 + u_z2 + h) = 0 inside; each slope by eq. (2).
  const elasticity::SurfaceQuadrature body1(steel, hertz_load(), 100);
  const elasticity::SurfaceQuadrature body2(rubber, hertz_load(), 100);
  for (const double share : {-0.95, -0.3, 0.123, 0.8}) {
    const double x = share * hertz.half_width();
    const double slope = body1.normal_gradient(x).value + body2.normal_gradient(x).value;
    BOOST_TEST(tolerance::relative_difference(slope, -cylinders.relative_curvature() * x) < 1e-9);
  }
}

BOOST_AUTO_TEST_CASE(the_gap_outside_is_that_of_equation_1b) {
  // u_z1 + u_z2 + h relative to the edge of the contact, each displacement by quadrature.
  const elasticity::SurfaceQuadrature body1(steel, hertz_load(), 100);
  const elasticity::SurfaceQuadrature body2(rubber, hertz_load(), 100);
  const auto sum = [&](double x) {
    return body1.normal_displacement(x).value + body2.normal_displacement(x).value +
           cylinders.profile().gap(x);
  };
  const double a = hertz.half_width();
  for (const double share : {1.01, 1.5, -3.0, 12.0}) {
    const double gap = sum(share * a) - sum(a);
    BOOST_TEST(std::abs(gap - hertz.gap(share * a)) < 1e-9 * cylinders.profile().gap(share * a));
  }
  BOOST_TEST(hertz.gap(0.9 * a) == 0);
}

BOOST_AUTO_TEST_CASE(the_approach_is_the_displacement_of_both_bodies_in_the_middle) {
  // Eq. (1a) at x = 0, where h = 0; each displacement by quadrature from the datum.
  const double a = hertz.half_width();
  for (const double share : {1.0001, 1.7, -12.0, 2385.0}) {
    const elasticity::SurfaceQuadrature body1(steel, hertz_load(), share * a);
    const elasticity::SurfaceQuadrature body2(rubber, hertz_load(), share * a);
    const double expected = body1.normal_displacement(0).value + body2.normal_displacement(0).value;
    BOOST_TEST(tolerance::relative_difference(hertz.approach(share * a), expected) < 1e-9);
  }
}

BOOST_AUTO_TEST_CASE(the_approach_at_a_datum_in_contact_is_the_gap_before_deformation) {
  const double a = hertz.half_width();
  for (const double share : {0.0, -0.385, 1.0}) {
    BOOST_TEST(std::abs(hertz.approach(share * a) - cylinders.profile().gap(share * a)) <
               1e-15 * cylinders.profile().gap(a));
  }
  BOOST_CHECK_THROW(hertz.approach(NAN), InvalidQuantity);
}

BOOST_AUTO_TEST_CASE(pressure_is_zero_from_the_edge_on) {
  BOOST_TEST(hertz.pressure(0) == hertz.peak_pressure());
  BOOST_TEST(hertz.pressure(hertz.half_width()) == 0);
  BOOST_TEST(hertz.pressure(-2 * hertz.half_width()) == 0);
}

BOOST_AUTO_TEST_CASE(a_load_must_be_positive) {
  BOOST_CHECK_THROW(Hertz(cylinders, 0), InvalidQuantity);
  BOOST_CHECK_THROW(Hertz(cylinders, -1), InvalidQuantity);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(mcewen)

using elasticity::Material;
using elasticity::Stress;
using line_contact::CylinderPair;
using line_contact::Hertz;
using line_contact::McEwen;
using line_contact::Radius;
using std::numbers::pi;
using sys::InvalidQuantity;
using tolerance::relative_difference;

namespace {

const Material steel(30e6, 0.3);
const Material rubber(700, 0.48);
const CylinderPair cylinders(steel, Radius::of_cylinder("radius1", 1), rubber,
                             Radius::of_cylinder("radius2", -2.385));
const Hertz hertz(cylinders, 3.5);
const McEwen mcewen(hertz);
const double a = hertz.half_width();
const double p0 = hertz.peak_pressure();

double distance(const Stress& s, const Stress& t) {
  return std::max({std::abs(s.xx - t.xx), std::abs(s.zz - t.zz), std::abs(s.xz - t.xz)});
}

struct Point {
  double x, z;  // in units of a
};

double relative_error(double value, const Precise& exact) {
  return exact == 0 ? std::abs(value) : abs((value - exact) / exact).toDouble();
}

// Sampled at a(−cos φ) for evenly spaced φ, or evenly spaced.
Stress sampled(int n, bool cosines, double x, double z) {
  std::vector<double> nodes;
  std::vector<double> pressures;
  for (int i = 0; i <= n; ++i) {
    const double share = static_cast<double>(i) / n;
    nodes.push_back(a * (cosines ? -std::cos(pi * share) : 2 * share - 1));
    pressures.push_back(i == 0 || i == n ? 0 : hertz.pressure(nodes.back()));
  }
  return elasticity::PiecewiseLinearTraction(nodes, pressures).stress(x, z);
}

}  // namespace

BOOST_AUTO_TEST_CASE(each_component_is_right_to_2e_15_from_the_surface_to_1e6_half_widths) {
  // Johnson (4.49a–c) as it stands, in 100 digits: far away near the surface it loses forty.
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

BOOST_AUTO_TEST_CASE(it_is_the_quadrature_of_line_forces_over_the_pressure) {
  // Johnson (2.23) with s = a sin φ, which takes the root out of the pressure.
  numerics::Quadrature quadrature;
  for (const Point& at : {Point{0.3, 0.4}, {-0.8, 0.15}, {1.0, 0.385}, {2.385, 1.7}, {0, 5}}) {
    const double x = at.x;
    const double z = at.z;
    const auto integral = [&](int power) {
      const auto force = [&](double angle) {
        const double t = x - std::sin(angle);
        const double pressure = p0 * std::pow(std::cos(angle), 2);
        return -2 / pi * pressure * std::pow(t, power) * std::pow(z, 3 - power) /
               std::pow(t * t + z * z, 2);
      };
      return quadrature.adaptive(force, -pi / 2, pi / 2, 1e-13 * p0, {"line forces", x}).value;
    };

    BOOST_TEST(distance(mcewen.stress(x * a, z * a), {integral(2), integral(0), integral(1)}) <
               1e-12 * p0);
  }
}

BOOST_AUTO_TEST_CASE(on_the_surface_both_normal_stresses_are_the_pressure) {
  for (const double share : {-0.97, -0.385, 0.0, 0.123, 0.999999, 1.0, 1.3, -40.0}) {
    const double x = share * a;
    const Stress surface = mcewen.stress(x, 0);
    const double rounding = 1e-13 * p0;  // of 1 − x²/a² in the pressure, beside the edge

    BOOST_TEST(std::abs(surface.xx + hertz.pressure(x)) < rounding);
    BOOST_TEST(std::abs(surface.zz + hertz.pressure(x)) < rounding);
    BOOST_TEST(surface.xz == 0);
  }
}

BOOST_AUTO_TEST_CASE(on_the_axis_it_is_johnsons_simpler_form) {
  // Johnson (4.46a, b): σ_xx = −(p₀/a) [(a²+2z²)/√(a²+z²) − 2z], σ_zz = −p₀ a/√(a²+z²).
  for (const double share : {0.01, 0.385, 0.786, 2.385}) {
    const double root = std::sqrt(1 + share * share);
    const Stress stress = mcewen.stress(0, share * a);

    BOOST_TEST(relative_difference(stress.xx, -p0 * ((1 + 2 * share * share) / root - 2 * share)) <
               1e-13);
    BOOST_TEST(relative_difference(stress.zz, -p0 / root) < 1e-14);
    BOOST_TEST(stress.xz == 0);
  }
}

BOOST_AUTO_TEST_CASE(normal_stresses_are_even_and_the_shear_odd) {
  RandomInputs random(62);
  for (int i = 0; i < 100; ++i) {
    const double x = a * random.uniform(0, 3);
    const double z = a * random.log_uniform(1e-6, 30);
    const Stress right = mcewen.stress(x, z);
    const Stress left = mcewen.stress(-x, z);
    BOOST_TEST((left.xx == right.xx && left.zz == right.zz && left.xz == -right.xz));
  }
}

BOOST_AUTO_TEST_CASE(the_greatest_shear_is_0_30028_p0_at_0_78615_a) {
  // Johnson, section 4.2, has 0.30 and 0.78.
  const line_contact::GreatestShear greatest = mcewen.greatest_shear();

  BOOST_TEST(std::abs(greatest.shear / p0 - 0.300283) < 0.5e-6);
  BOOST_TEST(std::abs(greatest.depth / a - 0.786151) < 0.5e-6);
}

BOOST_AUTO_TEST_CASE(the_greatest_shear_is_the_one_at_its_depth_and_no_other_on_the_axis) {
  RandomInputs random(63);
  for (int i = 0; i < 200; ++i) {
    const Hertz any(cylinders, random.log_uniform(1e-3, 1e3));
    const McEwen beneath(any);
    const auto [shear, depth] = beneath.greatest_shear();

    BOOST_TEST(relative_difference(shear, beneath.stress(0, depth).max_shear()) < 1e-14);
    const double elsewhere = depth * (1 + random.uniform(1e-6, 3) * (i % 2 == 0 ? 1 : -0.3));
    BOOST_TEST(beneath.stress(0, elsewhere).max_shear() < shear);
  }
}

BOOST_AUTO_TEST_CASE(nowhere_off_the_axis_is_the_shear_greater) {
  const double greatest = mcewen.greatest_shear().shear;
  for (int i = 0; i <= 60; ++i) {
    for (int j = 0; j <= 60; ++j) {
      const double x = a * 0.0331 * i;
      const double z = a * 0.0331 * j;
      BOOST_TEST(mcewen.stress(x, z).max_shear() <= greatest);
    }
  }
}

BOOST_AUTO_TEST_CASE(the_sampled_pressure_converges_to_it_at_order_2) {
  // With nodes as cosines. Evenly spaced ones give 3/2: the root at the edges costs √c·c.
  for (const Point& at : {Point{0.0, 0.786}, {0.385, 0.5}, {-1.1, 0.7}}) {
    const double x = at.x;
    const double z = at.z;
    for (const bool cosines : {true, false}) {
      const auto error = [&](int n) {
        return distance(sampled(n, cosines, x * a, z * a), mcewen.stress(x * a, z * a));
      };
      const double order = std::log2(error(256) / error(512));

      BOOST_TEST(std::abs(order - (cosines ? 2 : 1.5)) < 0.05);
      BOOST_TEST(error(512) < (cosines ? 1e-5 : 1e-4) * p0);
    }
  }
}

BOOST_AUTO_TEST_CASE(points_outside_the_body_are_refused) {
  BOOST_CHECK_THROW(mcewen.stress(0, -1e-9), InvalidQuantity);
  BOOST_CHECK_THROW(mcewen.stress(NAN, 0), InvalidQuantity);
  BOOST_CHECK_THROW(mcewen.stress(0, std::numeric_limits<double>::infinity()), InvalidQuantity);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE_END()
