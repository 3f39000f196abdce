// SPDX-License-Identifier: GPL-3.0-or-later
#include "elasticity/stress.hpp"

#include <algorithm>
#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "multiprecision.hpp"
#include "numbers.hpp"
#include "numerics/quadrature.hpp"

BOOST_AUTO_TEST_SUITE(stress_test)

using elasticity::Stress;
using elasticity::stress_beneath;
using std::numbers::inv_pi;

namespace {

Stress random_stress(RandomInputs& random) {
  return {random.uniform(-3.7, 2.9), random.uniform(-4.1, 1.3), random.uniform(-2.2, 2.6)};
}

double largest(const Stress& s) {
  return std::max({std::abs(s.xx), std::abs(s.zz), std::abs(s.xz)});
}
double distance(const Stress& a, const Stress& b) {
  Stress difference = -1 * b;
  return largest(difference += a);
}

// A line force P at the origin (Flamant; Johnson 2.23).
Stress flamant(double P, double x, double z) {
  const double radial = -2 * inv_pi * P * z / std::pow(x * x + z * z, 2);
  return {radial * x * x, radial * z * z, radial * x * z};
}

struct Segment {
  double x1, x2, p1, p2;
};

// In 100 digits: the antiderivatives of Johnson (2.23) in t = x − s with p = c + m t, one by one.
struct ExactStress {
  Precise xx, zz, xz;
};
ExactStress exact_stress(const Segment& e, double x_, double z_) {
  const Precise x = x_;
  const Precise z = z_;
  const auto between = [&](auto antiderivative) {
    return antiderivative(Precise(x - e.x1)) - antiderivative(Precise(x - e.x2));
  };
  // ∫ tᵏ/(t²+z²)² dt, k = 0 … 3
  const auto r2 = [&](const Precise& t) { return Precise(t * t + z * z); };
  const auto angle = [&](const Precise& t) { return Precise(atan(t / z)); };
  const Precise I0 = between([&](const Precise& t) {
    return Precise(t / (2 * z * z * r2(t)) + angle(t) / (2 * z * z * z));
  });
  const Precise I1 = between([&](const Precise& t) { return Precise(-1 / (2 * r2(t))); });
  const Precise I2 =
      between([&](const Precise& t) { return Precise(-t / (2 * r2(t)) + angle(t) / (2 * z)); });
  const Precise I3 =
      between([&](const Precise& t) { return Precise(log(r2(t)) / 2 + z * z / (2 * r2(t))); });
  const Precise m = -(Precise(e.p2) - e.p1) / (Precise(e.x2) - e.x1);
  const Precise c = e.p1 - m * (x - e.x1);
  const Precise factor = -2 / mpfr::const_pi();
  return {factor * z * (c * I2 + m * I3), factor * z * z * z * (c * I0 + m * I1),
          factor * z * z * (c * I1 + m * I2)};
}

}  // namespace

BOOST_AUTO_TEST_CASE(principal_stresses_and_greatest_shear_bound_those_on_all_planes) {
  RandomInputs random(41);
  constexpr int n_planes = 20000;
  for (int i = 0; i < 20; ++i) {
    const Stress s = random_stress(random);
    double greatest = -1e9, least = 1e9, shear = 0;
    for (int k = 0; k < n_planes; ++k) {
      const double angle = std::numbers::pi * k / n_planes;
      const double c = std::cos(angle), n = std::sin(angle);
      const double normal = s.xx * c * c + s.zz * n * n + 2 * s.xz * c * n;
      greatest = std::max(greatest, normal);
      least = std::min(least, normal);
      shear = std::max(shear, std::abs((s.zz - s.xx) * c * n + s.xz * (c * c - n * n)));
    }
    const auto principal = s.principal(0.29);
    const double across = 0.29 * (s.xx + s.zz);

    // The nearest plane misses the extreme one by half a step: 2 τ₁ (π/2n)², about 1e-7.
    BOOST_TEST(std::abs(principal.front() - std::max(greatest, across)) < 1e-6);
    BOOST_TEST(std::abs(principal.back() - std::min(least, across)) < 1e-6);
    BOOST_TEST(std::abs(s.max_shear() - shear) < 1e-6);
    BOOST_TEST(std::abs(s.largest_shear(0.29) - (principal.front() - principal.back()) / 2) <
               1e-15);
    BOOST_TEST(s.yy(0.29) == across);
  }
}

BOOST_AUTO_TEST_CASE(von_mises_follows_from_the_three_principal_stresses) {
  RandomInputs random(42);
  for (int i = 0; i < 200; ++i) {
    const Stress s = random_stress(random);
    const double nu = random.uniform(-0.99, 0.5);
    const auto [s1, s2, s3] = s.principal(nu);
    const double squares = std::pow(s1 - s2, 2) + std::pow(s2 - s3, 2) + std::pow(s3 - s1, 2);
    BOOST_TEST(std::abs(s.von_mises(nu) - std::sqrt(squares / 2)) < 1e-14);
  }
}

BOOST_AUTO_TEST_CASE(a_hydrostatic_stress_in_an_incompressible_body_leaves_no_rounding) {
  BOOST_TEST((Stress{-1e9, -1e9, 1}.von_mises(0.5)) == std::numbers::sqrt3);
}

BOOST_AUTO_TEST_CASE(a_segment_is_accurate_to_1e_14_of_its_pressure_near_and_far) {
  RandomInputs random(52);
  for (int i = 0; i < 4000; ++i) {
    // One end at 0, so that a point may be 1e-9 lengths beside it.
    const double length = random.log_uniform(1e-3, 1e3);
    const double x1 = random.sign() < 0 ? -length : 0;
    const Segment e{x1, x1 + length, random.uniform(-0.3, 2.385), random.uniform(-0.3, 2.385)};
    const double x = random.sign() * length * random.log_uniform(1e-9, 1e4);
    const double z = length * random.log_uniform(1e-9, 1e4);

    const ExactStress exact = exact_stress(e, x, z);
    const Stress found = stress_beneath(std::array{e.x1, e.x2}, std::array{e.p1, e.p2}, x, z);
    const double error =
        std::max({abs(found.xx - exact.xx), abs(found.zz - exact.zz), abs(found.xz - exact.xz)})
            .toDouble();
    // Far away the stress is that of the line force, of the order of pressure·length/distance.
    const double scale = std::min(1.0, length / std::hypot(x, z));
    BOOST_TEST_CONTEXT("x = " << x << ", z = " << z << ", length = " << length) {
      BOOST_TEST(error < 1e-14 * 2.385 * scale);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_pressure_at_nodes_is_the_quadrature_of_line_forces) {
  const std::vector<double> nodes = {-1.7, -1.1, -0.25, 0.3, 0.385, 1.9};
  const std::vector<double> pressures = {0, 1.3, 0.9, 2.385, 1.1, 0.4};
  numerics::Quadrature quadrature;
  RandomInputs random(51);
  for (int i = 0; i < 50; ++i) {
    const double x = random.uniform(-2.385, 2.385);
    const double z = random.uniform(0.05, 2.385);
    Stress expected;
    for (std::size_t k = 0; k + 1 < nodes.size(); ++k) {
      const auto component = [&](double Stress::*which) {
        const auto force = [&](double s) {
          const double share = (s - nodes[k]) / (nodes[k + 1] - nodes[k]);
          return flamant(std::lerp(pressures[k], pressures[k + 1], share), x - s, z).*which;
        };
        return quadrature.adaptive(force, nodes[k], nodes[k + 1], 1e-12, {"line forces", x}).value;
      };
      expected += {component(&Stress::xx), component(&Stress::zz), component(&Stress::xz)};
    }
    BOOST_TEST(distance(stress_beneath(nodes, pressures, x, z), expected) < 1e-11);
  }
}

BOOST_AUTO_TEST_CASE(stresses_beneath_a_strip_follow_from_its_two_angles) {
  // Johnson (2.30): with θ₁, θ₂ the angles to the edges, σ_xx, σ_zz = −(p/2π)[2(θ₁−θ₂) ± (sin 2θ₁ −
  // sin 2θ₂)], σ_xz = (p/2π)(cos 2θ₁ − cos 2θ₂).
  const double a = 0.7, p = 2.385;
  for (const double x : {-1.9, -0.3, 0.0, 0.71}) {
    for (const double z : {0.01, 0.385, 3.1}) {
      const double t1 = std::atan2(z, x - a), t2 = std::atan2(z, x + a);
      const double unit = -p * inv_pi / 2;
      const double sine = std::sin(2 * t1) - std::sin(2 * t2);
      const Stress expected{unit * (2 * (t1 - t2) + sine), unit * (2 * (t1 - t2) - sine),
                            -unit * (std::cos(2 * t1) - std::cos(2 * t2))};
      BOOST_TEST(distance(stress_beneath(std::array{-a, a}, std::array{p, p}, x, z), expected) <
                 1e-14 * p);
    }
  }
}

BOOST_AUTO_TEST_CASE(on_the_surface_the_stress_is_the_limit) {
  const std::array nodes = {-0.7, 0.0, 0.7};
  const std::array pressures = {0.0, 2.385, 0.0};
  for (const double x : {-1.1, -0.7, -0.2, 0.0, 0.65}) {
    const double p = std::max(0.0, 2.385 * (1 - std::abs(x) / 0.7));
    const Stress on = stress_beneath(nodes, pressures, x, 0);
    BOOST_TEST(distance(on, {-p, -p, 0}) < 1e-15 * 2.385);
    BOOST_TEST(distance(on, stress_beneath(nodes, pressures, x, 1e-9)) < 1e-7);
  }
}

BOOST_AUTO_TEST_SUITE_END()
