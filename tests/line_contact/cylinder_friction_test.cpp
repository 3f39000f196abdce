// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_contact/cylinder_friction.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <string>

#include "elasticity/surface_quadrature.hpp"
#include "line_contact/cauchy_integral.hpp"
#include "line_contact/cylinders.hpp"
#include "numerics/quadrature.hpp"
#include "random_inputs.hpp"
#include "system/require.hpp"
#include "tolerances.hpp"

BOOST_AUTO_TEST_SUITE(cylinder_friction_test)

BOOST_AUTO_TEST_SUITE(cattaneo_mindlin)

using line_contact::CattaneoMindlin;
using line_contact::CylinderPair;
using line_contact::Hertz;
using line_contact::Radius;
using std::numbers::pi;
using sys::InvalidQuantity;

namespace {

constexpr double load = 3.461;
constexpr double friction = 0.4173;
const elasticity::Material rubber(700, 0.48);
const Hertz hertz(CylinderPair(rubber, Radius::of_cylinder("radius1", 1.137), rubber,
                               Radius::of_cylinder("radius2", -2.385)),
                  load);
const double a = hertz.half_width();

constexpr double tangential = -0.6173 * friction * load;
const CattaneoMindlin partial(hertz, friction, tangential);
const double c = partial.stick_half_width();

// The kinks of q are at the edges of the stick zone.
double cauchy(double x) {
  return cauchy_integral([](double s) { return partial.traction(s); }, a, x, c);
}

// At the edges of the stick zone q has a root's infinite slope: what the quadratures then reach.
constexpr double beside_roots = 1e-10;

}  // namespace

BOOST_AUTO_TEST_CASE(traction_integrates_to_the_tangential_load) {
  // Far off, x ∫ q/(x−s) ds → Q, to (a/x)²/4.
  const double far = 2.385e7 * a;

  BOOST_TEST(tolerance::relative_difference(far * cauchy(far), tangential) < beside_roots);
}

BOOST_AUTO_TEST_CASE(the_stick_zone_is_that_of_johnson_7_28) {
  BOOST_TEST(tolerance::relative_difference(c, a * std::sqrt(1 - 0.6173)) < 1e-14);
  BOOST_TEST(partial.half_width() == a);
  BOOST_TEST(partial.tangential_load() == tangential);
}

BOOST_AUTO_TEST_CASE(nothing_slips_in_the_stick_zone) {
  // ∂(u_x1 − u_x2)/∂x = −(2/(πE*)) PV∫ q/(x−s) ds = 0 for |x| < c
  for (const double share : {-0.947, -0.313, 0.1234, 0.7713}) {
    BOOST_TEST(std::abs(cauchy(share * c)) < beside_roots * std::abs(tangential) / a);
  }
}

BOOST_AUTO_TEST_CASE(slip_opposes_the_traction) {
  // Off the stick zone PV∫ q/(x−s) ds = ± π (μp₀/a) √(x²−c²) sgn x. Where q > 0 pulls body 1 along
  // x, u_x1 − u_x2 falls from the stick zone to both sides: it slips against q.
  for (const double share : {-0.947, -0.713, 0.7234, 0.9713}) {
    const double x = share * a;
    const double expected = std::copysign(pi * friction * hertz.peak_pressure() / a, tangential) *
                            std::copysign(std::sqrt((x - c) * (x + c)), x);
    BOOST_TEST(tolerance::relative_difference(cauchy(x), expected) < beside_roots);
  }
}

BOOST_AUTO_TEST_CASE(traction_never_exceeds_friction_and_is_friction_where_it_slips) {
  constexpr int n_points = 2385;
  for (const double share : {1e-15, 3.1e-9, 0.0237, 0.6173, 0.99713}) {
    const CattaneoMindlin shear(hertz, friction, share * friction * load);
    int n_wrong = 0;
    for (int i = -n_points; i <= n_points; ++i) {
      const double x = 1.01 * a * i / n_points;
      const double q = shear.traction(x);
      const double limit = friction * hertz.pressure(x);
      const bool sticks = std::abs(x) < shear.stick_half_width();
      if (!(q >= 0 && (sticks ? q <= limit : q == limit))) ++n_wrong;
    }
    BOOST_TEST(n_wrong == 0);
  }
}

BOOST_AUTO_TEST_CASE(traction_does_not_exceed_friction_beside_the_rounded_edge_of_stick) {
  int n_wrong = 0;
  for (double share = 1e-15; share < 0.9; share *= 1.2385) {
    const CattaneoMindlin shear(hertz, friction, share * friction * load);
    double x = shear.stick_half_width();
    for (int i = 0; i < 8; ++i) {
      if (shear.traction(x) > friction * hertz.pressure(x)) ++n_wrong;
      x = std::nextafter(x, 0);
    }
  }

  BOOST_TEST(n_wrong == 0);
}

BOOST_AUTO_TEST_CASE(traction_is_the_difference_of_two_ellipses) {
  // Johnson (7.24), (7.25)
  const double x = -0.3713 * c;
  const double scale = std::copysign(friction, tangential) * hertz.peak_pressure();
  const double expected =
      scale * (std::sqrt(1 - x * x / (a * a)) - c / a * std::sqrt(1 - x * x / (c * c)));

  BOOST_TEST(tolerance::relative_difference(partial.traction(x), expected) < 1e-14);
}

BOOST_AUTO_TEST_CASE(traction_turns_with_the_load) {
  const CattaneoMindlin reversed(hertz, friction, -tangential);

  for (const double x : {-0.9137 * a, 0.2385 * a, 0.9137 * a}) {
    BOOST_TEST(partial.traction(x) < 0);
    BOOST_TEST(reversed.traction(x) == -partial.traction(x));
    BOOST_TEST(reversed.traction(x) == reversed.traction(-x));
  }
}

BOOST_AUTO_TEST_CASE(without_a_load_all_sticks_and_nothing_is_transmitted) {
  const CattaneoMindlin none(hertz, friction, 0);

  BOOST_TEST(none.stick_half_width() == a);
  for (const double share : {0.0, 0.3137, -1.0, 1.0, 2.385}) {
    BOOST_TEST(none.traction(share * a) == 0);
  }
}

BOOST_AUTO_TEST_CASE(a_small_load_keeps_its_digits) {
  // c → a: q → Q/(π√(a²−x²)), to a part in Q/(μP) = 1e-14
  const double small = 1e-14 * friction * load;
  const CattaneoMindlin shear(hertz, friction, small);
  const double x = 0.6137 * a;
  const double expected = small / (pi * std::sqrt((a - x) * (a + x)));

  BOOST_TEST(tolerance::relative_difference(shear.traction(x), expected) < 1e-13);
}

BOOST_AUTO_TEST_CASE(a_load_that_slides_and_bad_friction_are_refused) {
  const auto says_sliding = [](const InvalidQuantity& error) {
    return error.quantity() == "tangential_load" &&
           error.allowed().find("sliding") != std::string::npos;
  };
  const double limit = friction * load * (1 + 1e-14);
  BOOST_CHECK_EXCEPTION(CattaneoMindlin(hertz, friction, limit), InvalidQuantity, says_sliding);
  BOOST_CHECK_EXCEPTION(CattaneoMindlin(hertz, friction, -limit), InvalidQuantity, says_sliding);
  BOOST_CHECK_NO_THROW(CattaneoMindlin(hertz, friction, -limit * (1 - 1e-13)));
  BOOST_CHECK_THROW(CattaneoMindlin(hertz, friction, std::nan("")), InvalidQuantity);
  BOOST_CHECK_THROW(CattaneoMindlin(hertz, 0, 0), InvalidQuantity);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(sliding_hertz)

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

BOOST_AUTO_TEST_SUITE(coupled_sliding)

using elasticity::Material;
using line_contact::CoupledSliding;
using line_contact::CylinderPair;
using line_contact::Hertz;
using line_contact::Radius;
using std::numbers::pi;
using sys::InvalidQuantity;
using tolerance::relative_difference;

namespace {

constexpr double load = 3.461;
const Material steel(30e6, 0.29);
const Material rubber(700, 0.38);

CylinderPair cylinders_of(const Material& first, const Material& second) {
  return {first, Radius::of_cylinder("radius1", 1.137), second,
          Radius::of_cylinder("radius2", -2.385)};
}

// The departure of the two bodies' slopes by eq. (2) from −x/R, over a/R.
double departure(const CylinderPair& cylinders, const Material& first, const Material& second,
                 double friction) {
  const CoupledSliding exact(cylinders, load, friction, elasticity::dundurs_beta(first, second));
  const double a = exact.half_width();
  const auto body = [&](const Material& material, double mu) {
    return elasticity::SurfaceQuadrature(
        material,
        elasticity::distributed_load([&](double x) { return exact.pressure(x); },
                                     [&, mu](double x) { return mu * exact.pressure(x); },
                                     {exact.shift() - a, exact.shift(), exact.shift() + a}),
        10 * a);
  };
  const auto body1 = body(first, friction);
  const auto body2 = body(second, -friction);
  double largest = 0;
  for (const double share : {-0.97, -0.31, 0.0, 0.123, 0.9}) {
    const double x = exact.shift() + share * a;
    const double slope = body1.normal_gradient(x).value + body2.normal_gradient(x).value;
    largest = std::max(largest, std::abs(slope / cylinders.relative_curvature() + x) / a);
  }
  return largest;
}

}  // namespace

BOOST_AUTO_TEST_CASE(with_its_shear_the_pressure_closes_the_gap_by_equations_1a_and_2) {
  const CylinderPair soft_first = cylinders_of(rubber, steel);
  const CylinderPair soft_second = cylinders_of(steel, rubber);
  for (const double friction : {-1.9, 0.3, 0.8}) {
    BOOST_TEST(departure(soft_first, rubber, steel, friction) < 1e-11);
    BOOST_TEST(departure(soft_second, steel, rubber, friction) < 1e-11);
  }
}

BOOST_AUTO_TEST_CASE(pressure_integrates_to_the_load) {
  // ∫ (a+t)^{1/2+γ} (a−t)^{1/2−γ} dt = (2a)² B(3/2+γ, 3/2−γ), NIST DLMF 5.12.1
  const CylinderPair cylinders = cylinders_of(rubber, steel);
  for (const double friction : {0.3, -2.385, 7.1}) {
    const CoupledSliding contact(cylinders, load, friction, 0.2385);
    const double a = contact.half_width();
    const double factor = contact.pressure(contact.shift()) / a;  // at t = 0
    const double integral =
        factor * 4 * a * a * std::beta(1.5 + contact.gamma(), 1.5 - contact.gamma());
    BOOST_TEST(relative_difference(integral, load) < 1e-14);
  }
}

BOOST_AUTO_TEST_CASE(without_friction_or_between_like_bodies_it_is_hertz) {
  const CylinderPair cylinders = cylinders_of(rubber, steel);
  const Hertz hertz(cylinders, load);
  for (const CoupledSliding& same :
       {CoupledSliding(cylinders, load, 0, 0.2385), CoupledSliding(cylinders, load, 0.4173, 0)}) {
    BOOST_TEST(same.half_width() == hertz.half_width());
    BOOST_TEST(same.shift() == 0);
    for (const double share : {-0.97, 0.123, 0.8}) {
      const double x = share * hertz.half_width();
      BOOST_TEST(relative_difference(same.pressure(x), hertz.pressure(x)) < 1e-14);
    }
  }
}

BOOST_AUTO_TEST_CASE(gamma_is_that_of_tan_pi_gamma_and_turns_with_the_shear) {
  const CylinderPair cylinders = cylinders_of(rubber, steel);
  const CoupledSliding right(cylinders, load, 0.4173, 0.2385);
  const CoupledSliding left(cylinders, load, -0.4173, 0.2385);

  BOOST_TEST(relative_difference(std::tan(pi * right.gamma()), -0.4173 * 0.2385) < 1e-14);
  BOOST_TEST(relative_difference(right.shift(), 2 * right.gamma() * right.half_width()) < 1e-15);
  for (const double x : {-0.01, 0.0, 0.02}) {
    BOOST_TEST(relative_difference(left.pressure(-x), right.pressure(x)) < 1e-13);
  }
}

BOOST_AUTO_TEST_CASE(outside_the_contact_nothing_presses) {
  const CoupledSliding contact(cylinders_of(rubber, steel), load, 0.8, 0.2385);

  BOOST_TEST(contact.pressure(contact.shift() + 1.01 * contact.half_width()) == 0);
  BOOST_TEST(contact.pressure(contact.shift() - 2.385 * contact.half_width()) == 0);
}

BOOST_AUTO_TEST_CASE(inputs_that_are_not_finite_and_loads_that_do_not_press_are_refused) {
  const CylinderPair cylinders = cylinders_of(rubber, steel);
  BOOST_CHECK_THROW(CoupledSliding(cylinders, 0, 0.3, 0.2), InvalidQuantity);
  BOOST_CHECK_THROW(CoupledSliding(cylinders, load, NAN, 0.2), InvalidQuantity);
  BOOST_CHECK_THROW(CoupledSliding(cylinders, load, 0.3, INFINITY), InvalidQuantity);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE_END()
