// SPDX-License-Identifier: GPL-3.0-or-later
#include "elasticity/interior_stress.hpp"

#include <algorithm>
#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "multiprecision.hpp"
#include "numerics/kernel_integrals.hpp"
#include "numerics/quadrature.hpp"
#include "random_inputs.hpp"
#include "system/require.hpp"
#include "tolerances.hpp"

BOOST_AUTO_TEST_SUITE(interior_stress_test)

using elasticity::LinearSegment;
using elasticity::PiecewiseLinearTraction;
using elasticity::Stress;
using elasticity::stress_under;
using elasticity::TriangularLoad;
using std::numbers::inv_pi;
using sys::InvalidQuantity;
using tolerance::relative_difference;

namespace {

// What the docstring promises, in units of the scale it names.
constexpr double promised = 1e-14;

// The quadrature is asked for 1e-12.
constexpr double by_quadrature = 1e-11;

// Tractions with jumps at neither end, unevenly spaced, with a change of sign in q.
const std::vector<double> nodes = {-1.7, -1.1, -0.25, 0.3, 0.385, 1.9};
const std::vector<double> pressures = {0, 1.3, 0.9, 2.385, 1.1, 0};
const std::vector<double> shears = {0, 0.4, -0.35, 0.8, 0.2, 0};
const PiecewiseLinearTraction traction(nodes, pressures, shears);

double largest(const Stress& s) {
  return std::max({std::abs(s.xx), std::abs(s.zz), std::abs(s.xz)});
}
double distance(const Stress& a, const Stress& b) {
  return largest(a + -1 * b);
}

// A line force (P, Q) at the origin: Johnson, sections 2.2 and 2.3.
Stress flamant(double P, double Q, double x, double z) {
  const double radial = -2 * inv_pi * (P * z + Q * x) / std::pow(x * x + z * z, 2);
  return {radial * x * x, radial * z * z, radial * x * z};
}

// Johnson (2.23): line forces integrated over [s1, s2], one component at a time.
template <class P, class Q>
Stress integrated(P p, Q q, double s1, double s2, double x, double z) {
  numerics::Quadrature quadrature;
  const auto integral = [&](double Stress::*component) {
    const auto force = [&](double s) { return flamant(p(s), q(s), x - s, z).*component; };
    return quadrature.adaptive(force, s1, s2, 1e-12, {"line forces", x}).value;
  };
  return {integral(&Stress::xx), integral(&Stress::zz), integral(&Stress::xz)};
}

Stress integrated(const LinearSegment& e, double x, double z) {
  const auto between = [&](double s, double v1, double v2) {
    return v1 + (v2 - v1) * (s - e.x1) / (e.x2 - e.x1);
  };
  return integrated([&](double s) { return between(s, e.p1, e.p2); },
                    [&](double s) { return between(s, e.q1, e.q2); }, e.x1, e.x2, x, z);
}

// In 100 digits, as far away they cancel: the antiderivatives of Johnson (2.23) in t = x − s with p
// = c + m t, one by one.
struct ExactStress {
  Precise xx, zz, xz;
};
ExactStress exact_stress(const LinearSegment& e, double x_, double z_) {
  const Precise x = x_;
  const Precise z = z_;
  const Precise length = Precise(e.x2) - e.x1;
  const auto between = [&](auto antiderivative) {
    return antiderivative(Precise(x - e.x1)) - antiderivative(Precise(x - e.x2));
  };
  // ∫ tᵏ/(t²+z²)² dt, k = 0 … 4
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
  const Precise I4 = between([&](const Precise& t) {
    return Precise(t + z * z * t / (2 * r2(t)) - 3 * z * angle(t) / 2);
  });
  const Precise mp = -(Precise(e.p2) - e.p1) / length;
  const Precise mq = -(Precise(e.q2) - e.q1) / length;
  const Precise cp = e.p1 - mp * (x - e.x1);
  const Precise cq = e.q1 - mq * (x - e.x1);
  const Precise factor = -2 / mpfr::const_pi();
  return {factor * (z * (cp * I2 + mp * I3) + cq * I3 + mq * I4),
          factor * (z * z * z * (cp * I0 + mp * I1) + z * z * (cq * I1 + mq * I2)),
          factor * (z * z * (cp * I1 + mp * I2) + z * (cq * I2 + mq * I3))};
}

double distance(const Stress& a, const ExactStress& b) {
  const Precise error =
      std::max({Precise(abs(a.xx - b.xx)), Precise(abs(a.zz - b.zz)), Precise(abs(a.xz - b.xz))});
  return error.toDouble();
}
double largest(const ExactStress& s) {
  return std::max({Precise(abs(s.xx)), Precise(abs(s.zz)), Precise(abs(s.xz))}).toDouble();
}

struct Point {
  double x, z;
};
// A point from 1e-9 to 1e6 lengths from an end, now and then above or below it.
Point random_point(RandomInputs& random, const LinearSegment& e) {
  const double length = e.x2 - e.x1;
  const double end = random.sign() < 0 ? e.x1 : e.x2;
  const double across = random.uniform(0, 1) < 0.1 ? 0 : random.log_uniform(1e-9, 1e6);
  return {end + random.sign() * length * across, length * random.log_uniform(1e-9, 1e6)};
}
// One end at 0, so that a point may be 1e-9 lengths beside it.
LinearSegment random_segment(RandomInputs& random) {
  const double length = random.log_uniform(1e-3, 1e3);
  return random.sign() < 0 ? LinearSegment{-length, 0, 0, 0} : LinearSegment{0, length, 0, 0};
}
double random_end_value(RandomInputs& random) {
  return random.uniform(0, 1) < 0.25 ? 0 : random.uniform(0.1, 2.385);
}

}  // namespace

BOOST_AUTO_TEST_CASE(one_segment_is_the_quadrature_of_line_forces) {
  RandomInputs random(51);
  for (int i = 0; i < 200; ++i) {
    const double x1 = random.uniform(-2, 1);
    const LinearSegment segment{x1,
                                x1 + random.log_uniform(0.05, 2),
                                random.uniform(-1, 2),
                                random.uniform(-1, 2),
                                random.uniform(-1, 1),
                                random.uniform(-1, 1)};
    const double x = random.uniform(-2.385, 2.385);
    const double z = random.uniform(0.05, 2.385);
    BOOST_TEST(distance(stress_under(segment, x, z), integrated(segment, x, z)) < by_quadrature);
  }
}

BOOST_AUTO_TEST_CASE(a_pressure_is_right_to_1e_14_of_the_largest_component_near_and_far) {
  RandomInputs random(52);
  for (int i = 0; i < 4000; ++i) {
    LinearSegment segment = random_segment(random);
    segment.p1 = random_end_value(random);
    segment.p2 = random_end_value(random);
    const auto [x, z] = random_point(random, segment);

    const ExactStress exact = exact_stress(segment, x, z);
    BOOST_TEST(distance(stress_under(segment, x, z), exact) <= promised * largest(exact));
  }
}

BOOST_AUTO_TEST_CASE(a_shear_is_right_to_1e_14_of_its_line_force_near_and_far) {
  RandomInputs random(53);
  for (int i = 0; i < 4000; ++i) {
    LinearSegment segment = random_segment(random);
    segment.q1 = random.sign() * random_end_value(random);
    segment.q2 = random.sign() * random_end_value(random);
    const auto [x, z] = random_point(random, segment);

    const double length = segment.x2 - segment.x1;
    const double away = std::hypot(x - (segment.x1 + segment.x2) / 2, z);
    const double scale =
        std::max(std::abs(segment.q1), std::abs(segment.q2)) * std::min(1.0, length / away);
    BOOST_TEST(distance(stress_under(segment, x, z), exact_stress(segment, x, z)) <=
               promised * scale);
  }
}

BOOST_AUTO_TEST_CASE(a_triangle_has_johnsons_stresses) {
  // Johnson (2.36) as it stands.
  const double a = 0.7;
  const double p0 = 2.385;
  const TriangularLoad load(p0, a);
  for (const auto& [x, z] : {Point{0.2, 0.1}, {-0.9, 0.35}, {0.7, 1.3}, {0, 0.55}, {-0.31, 2.9}}) {
    const double left = std::atan2(z, x + a);
    const double right = std::atan2(z, x - a);
    const double middle = std::atan2(z, x);
    const double logarithm =
        std::log(std::hypot(x + a, z) * std::hypot(x - a, z) / (x * x + z * z));
    const double unit = p0 / a * inv_pi;
    const double zz = unit * ((x + a) * left + (x - a) * right - 2 * x * middle);
    const Stress expected{zz + unit * 2 * z * logarithm, zz,
                          -unit * z * (left + right - 2 * middle)};

    BOOST_TEST(distance(stress_under(load, x, z), expected) < 1e-14 * p0);
  }
}

BOOST_AUTO_TEST_CASE(a_triangle_is_two_segments) {
  const TriangularLoad load(2.385, 0.7);
  const PiecewiseLinearTraction same(std::array{-0.7, 0.0, 0.7}, std::array{0.0, 2.385, 0.0});
  RandomInputs random(54);
  for (int i = 0; i < 200; ++i) {
    const double x = 0.7 * random.point(1e6);
    const double z = i % 4 == 0 ? 0 : 0.7 * random.log_uniform(1e-9, 1e6);
    const Stress expected = stress_under(LinearSegment{-0.7, 0, 0, 2.385}, x == 0 ? 1e-17 : x, z) +
                            stress_under(LinearSegment{0, 0.7, 2.385, 0}, x == 0 ? 1e-17 : x, z);

    BOOST_TEST(distance(stress_under(load, x, z), expected) <= 1e-14 * largest(expected));
    BOOST_TEST(distance(same.stress(x, z), expected) <= 1e-14 * largest(expected));
  }
}

BOOST_AUTO_TEST_CASE(a_sum_of_triangles_is_the_quadrature_of_line_forces) {
  for (const auto& [x, z] : {Point{0.2, 0.1}, {-1.1, 0.35}, {2.385, 0.5}, {0.385, 0.07}}) {
    Stress expected;
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
      expected += integrated(
          {nodes[i], nodes[i + 1], pressures[i], pressures[i + 1], shears[i], shears[i + 1]}, x, z);
    }

    BOOST_TEST(distance(traction.stress(x, z), expected) < by_quadrature);
  }
}

BOOST_AUTO_TEST_CASE(on_the_surface_the_tractions_return) {
  // −σ_zz = p, −σ_xz = q and σ_xx = −p − (2/π) PV∫ q/(x−s) ds, at nodes, under and off the load.
  std::vector<numerics::Piece> pieces;
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
    pieces.push_back({nodes[i], nodes[i + 1], [](double s) { return traction.shear(s); }});
  }
  const numerics::KernelIntegrals shear{numerics::PiecewiseFunction(pieces)};
  for (const double x : {-4.5, -1.7, -1.3, -1.1, -0.25, 0.0, 0.3, 0.31, 0.385, 1.2, 1.9, 3.3}) {
    const Stress surface = traction.stress(x, 0);
    const double xx = -traction.pressure(x) - 2 * inv_pi * shear.cauchy(x).value;

    BOOST_TEST(surface.zz == -traction.pressure(x));
    BOOST_TEST(surface.xz == -traction.shear(x));
    BOOST_TEST(std::abs(surface.xx - xx) < 1e-11);
  }
}

BOOST_AUTO_TEST_CASE(the_surface_is_approached_continuously) {
  // By less than the depth times the slopes times a logarithm.
  for (const double x : {-4.5, -1.7, -1.3, -1.1, -0.25, 0.0, 0.3, 0.31, 0.385, 1.2, 1.9, 3.3}) {
    for (const double z : {1e-9, 1e-12, 1e-30, 1e-100, 1e-300, 5e-324}) {
      BOOST_TEST(distance(traction.stress(x, z), traction.stress(x, 0)) < 2000 * z + 1e-13);
    }
  }
  const LinearSegment step{-0.4, 1.1, 1.3, 0.7, 0.2, 0.9};
  for (const double x : {-0.9, -0.39999, 0.385, 1.0999, 2.0}) {
    BOOST_TEST(distance(stress_under(step, x, 1e-14), stress_under(step, x, 0)) < 1e-8);
  }
}

BOOST_AUTO_TEST_CASE(tractions_between_nodes_are_linear_and_outside_zero) {
  BOOST_TEST(relative_difference(traction.pressure(-1.4), 0.65) < tolerance::rounding);
  BOOST_TEST(relative_difference(traction.shear(0.3425), 0.5) < 1e-14);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    BOOST_TEST(traction.pressure(nodes[i]) == pressures[i]);
    BOOST_TEST(traction.shear(nodes[i]) == shears[i]);
  }
  BOOST_TEST(traction.pressure(-1.71) == 0);
}

BOOST_AUTO_TEST_CASE(a_horizontal_plane_carries_the_resultants) {
  // ∫σ_zz dx = −P and ∫σ_xz dx = −Q, with x = d tan φ.
  double P = 0;
  double Q = 0;
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
    P += (nodes[i + 1] - nodes[i]) * (pressures[i] + pressures[i + 1]) / 2;
    Q += (nodes[i + 1] - nodes[i]) * (shears[i] + shears[i + 1]) / 2;
  }
  numerics::Quadrature quadrature;
  for (const double z : {0.1, 0.385, 2.7}) {
    const auto resultant = [&](double Stress::*component) {
      const auto f = [&](double angle) {
        const double x = std::tan(angle);
        return traction.stress(x, z).*component * (1 + x * x);
      };
      return quadrature.adaptive(f, -std::numbers::pi / 2, std::numbers::pi / 2, 1e-10, {"σ", z});
    };
    BOOST_TEST(std::abs(resultant(&Stress::zz).value + P) < 1e-9);
    BOOST_TEST(std::abs(resultant(&Stress::xz).value + Q) < 1e-9);
  }
}

BOOST_AUTO_TEST_CASE(the_stresses_are_in_equilibrium_and_compatible) {
  // Sixth-order differences: truncation (h/z)⁶, rounding ε/h and ε/h².
  constexpr double h = 0.004;
  const auto first = [](auto f) {
    return (45 * (f(h) - f(-h)) - 9 * (f(2 * h) - f(-2 * h)) + (f(3 * h) - f(-3 * h))) / (60 * h);
  };
  const auto second = [](auto f) {
    return (270 * (f(h) + f(-h)) - 27 * (f(2 * h) + f(-2 * h)) + 2 * (f(3 * h) + f(-3 * h)) -
            490 * f(0.0)) /
           (180 * h * h);
  };
  for (const auto& [x, z] : {Point{0.2, 0.6}, {-1.1, 0.5}, {2.385, 0.7}, {0.385, 1.2}}) {
    const auto along_x = [&](double d) { return traction.stress(x + d, z); };
    const auto along_z = [&](double d) { return traction.stress(x, z + d); };
    const auto trace = [](const Stress& s) { return s.xx + s.zz; };

    BOOST_TEST(std::abs(first([&](double d) { return along_x(d).xx; }) +
                        first([&](double d) { return along_z(d).xz; })) < 1e-9);
    BOOST_TEST(std::abs(first([&](double d) { return along_x(d).xz; }) +
                        first([&](double d) { return along_z(d).zz; })) < 1e-9);
    BOOST_TEST(std::abs(second([&](double d) { return trace(along_x(d)); }) +
                        second([&](double d) { return trace(along_z(d)); })) < 1e-8);
  }
}

BOOST_AUTO_TEST_CASE(an_even_pressure_and_an_even_shear_have_their_symmetries) {
  const PiecewiseLinearTraction normal(std::array{-1.3, -0.4, 0.4, 1.3},
                                       std::array{0.2, 0.9, 0.9, 0.2});
  const PiecewiseLinearTraction tangential(std::array{-1.3, -0.4, 0.4, 1.3}, {},
                                           std::array{0.2, 0.9, 0.9, 0.2});
  RandomInputs random(55);
  for (int i = 0; i < 100; ++i) {
    const double x = random.uniform(-4, 4);
    const double z = random.log_uniform(1e-6, 50);
    const Stress n = normal.stress(x, z);
    const Stress t = tangential.stress(x, z);
    BOOST_TEST(distance(normal.stress(-x, z), Stress{n.xx, n.zz, -n.xz}) < 1e-14);
    BOOST_TEST(distance(tangential.stress(-x, z), Stress{-t.xx, -t.zz, t.xz}) < 1e-14);
  }
}

BOOST_AUTO_TEST_CASE(far_away_only_the_resultant_counts) {
  // About the centre of each traction the next term is of order (width/r)².
  const LinearSegment segment{-0.3, 0.3, 2.385, 2.385, 0.9, 0.9};
  for (const double r : {30.0, 3e3, 3e5}) {
    for (const double angle : {0.3, 1.1, 2.6}) {
      const auto [x, z] = Point{r * std::cos(angle), r * std::sin(angle)};
      const Stress force = flamant(0.6 * 2.385, 0.6 * 0.9, x, z);
      BOOST_TEST(distance(stress_under(segment, x, z), force) < (1 / (r * r) + 1e-14) / r);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_thousand_nodes_keep_their_digits_far_away) {
  // A triangle sampled at 2001 nodes is the triangle.
  std::vector<double> x;
  std::vector<double> p;
  for (int i = -1000; i <= 1000; ++i) {
    x.push_back(i * 0x1p-10);
    p.push_back((1000 - std::abs(i)) * 0x1p-10);
  }
  const PiecewiseLinearTraction sampled(x, p);
  const TriangularLoad triangle(1000 * 0x1p-10, 1000 * 0x1p-10);
  RandomInputs random(56);
  for (int i = 0; i < 100; ++i) {
    const double at = random.point(1e6);
    const double z = random.log_uniform(1e-9, 1e6);
    const Stress expected = stress_under(triangle, at, z);

    BOOST_TEST(distance(sampled.stress(at, z), expected) < 1e-13 * largest(expected));
  }
}

BOOST_AUTO_TEST_CASE(points_outside_the_body_and_at_jumps_are_refused) {
  const LinearSegment step{-0.4, 1.1, 1.3, 0};
  const LinearSegment shear_step{-0.4, 1.1, 0, 0, 0, 0.2};
  const TriangularLoad load(2.385, 0.7);
  const PiecewiseLinearTraction both(std::array{-0.4, 1.1}, std::array{1.3, 0.0},
                                     std::array{0.0, 0.2});

  BOOST_CHECK_THROW(stress_under(step, 0, -1e-9), InvalidQuantity);
  BOOST_CHECK_THROW(stress_under(step, NAN, 1), InvalidQuantity);
  BOOST_CHECK_THROW(stress_under(load, 0, -1), InvalidQuantity);
  BOOST_CHECK_THROW(stress_under(load, HUGE_VAL, 1), InvalidQuantity);
  BOOST_CHECK_THROW(both.stress(0, HUGE_VAL), InvalidQuantity);
  BOOST_CHECK_THROW(stress_under(step, -0.4, 0), InvalidQuantity);
  BOOST_CHECK_NO_THROW(stress_under(step, 1.1, 0));
  BOOST_CHECK_NO_THROW(stress_under(step, -0.4, 1e-9));
  BOOST_CHECK_THROW(stress_under(shear_step, 1.1, 0), InvalidQuantity);
  BOOST_CHECK_THROW(both.stress(-0.4, 0), InvalidQuantity);
  BOOST_CHECK_THROW(both.stress(1.1, 0), InvalidQuantity);
}

BOOST_AUTO_TEST_CASE(tractions_that_make_no_sense_are_refused) {
  using Span = std::vector<double>;

  BOOST_CHECK_THROW(stress_under(LinearSegment{1, 1, 1, 1}, 0, 1), InvalidQuantity);
  BOOST_CHECK_THROW(stress_under(LinearSegment{0, NAN, 1, 1}, 0, 1), InvalidQuantity);
  BOOST_CHECK_THROW(stress_under(LinearSegment{0, 1, NAN, 1}, 0, 1), InvalidQuantity);
  BOOST_CHECK_THROW(stress_under(LinearSegment{0, 1, 1, 1, 0, NAN}, 0, 1), InvalidQuantity);
  BOOST_CHECK_THROW(PiecewiseLinearTraction(Span{1}, Span{1}), InvalidQuantity);
  BOOST_CHECK_THROW(PiecewiseLinearTraction(Span{}, Span{}), InvalidQuantity);
  BOOST_CHECK_THROW(PiecewiseLinearTraction(Span{1, 1}, Span{1, 1}), InvalidQuantity);
  BOOST_CHECK_THROW(PiecewiseLinearTraction(Span{-0.4, 1.1}, Span{1, 2, 3}), InvalidQuantity);
  BOOST_CHECK_THROW(PiecewiseLinearTraction(Span{-0.4, 1.1}, Span{1, NAN}), InvalidQuantity);
  BOOST_CHECK_THROW(PiecewiseLinearTraction(Span{-0.4, 1.1}, Span{}, Span{1}), InvalidQuantity);
}

BOOST_AUTO_TEST_SUITE_END()
