// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/closed_forms/spheres.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "multiprecision.hpp"
#include "numerics/quadrature.hpp"
#include "point_contact/polar_quadrature.hpp"
#include "system/require.hpp"
#include "tolerances.hpp"

BOOST_AUTO_TEST_SUITE(spheres_test)

BOOST_AUTO_TEST_SUITE(hertz)

using point_contact::Hertz;
using sys::InvalidQuantity;
using tolerance::relative_difference;

namespace {

constexpr double modulus = 913.7;
constexpr double curvature = 0.571;
constexpr double load = 3.461;
const Hertz hertz(modulus, curvature, load);
const double a = hertz.radius();

double pressure(double r) {
  return hertz.pressure(r);
}

// u_z1 + u_z2 by quadrature.
double displacement(double r) {
  return axial_potential(pressure, a, r) / (std::numbers::pi * modulus);
}

}  // namespace

BOOST_AUTO_TEST_CASE(radius_peak_and_approach_belong_together) {
  // Johnson 4.22–4.24: p₀ = 2aE*κ/π, δ = κa² = πap₀/(2E*)
  BOOST_TEST(relative_difference(hertz.peak_pressure(),
                                 2 * a * modulus * curvature / std::numbers::pi) < 1e-15);
  BOOST_TEST(relative_difference(hertz.approach(), std::numbers::pi * a * hertz.peak_pressure() /
                                                       (2 * modulus)) < 1e-15);
}

BOOST_AUTO_TEST_CASE(pressure_integrates_to_the_load) {
  numerics::Quadrature quadrature;
  const auto ring = [](double r) { return 2 * std::numbers::pi * r * pressure(r); };
  const double total = quadrature.smooth(ring, 0, a, 1e-10 * load, {"the load", 0}).value;

  BOOST_TEST(relative_difference(total, load) < 1e-9);
}

BOOST_AUTO_TEST_CASE(pressure_closes_the_gap_by_equation_1a) {
  for (const double share : {0.0, 0.3, 0.9}) {
    const double r = share * a;
    const double sum = displacement(r) + curvature * r * r / 2;
    BOOST_TEST(relative_difference(sum, hertz.approach()) < 1e-8);
    BOOST_TEST(hertz.gap(r) == 0);
  }
}

BOOST_AUTO_TEST_CASE(the_gap_outside_is_that_of_equation_1b) {
  for (const double share : {1.05, 1.5, 3.0, 12.0}) {
    const double r = share * a;
    const double h = curvature * r * r / 2;
    BOOST_TEST(std::abs(displacement(r) + h - hertz.approach() - hertz.gap(r)) < 1e-8 * h);
  }
}

BOOST_AUTO_TEST_CASE(the_gap_keeps_its_digits_near_the_edge) {
  // (κa²/π) [t tan²t + tan t − t] in a hundred digits
  for (const double beyond : {1e-12, 1e-6, 1e-2, 0.3, 2.0, 1e3}) {
    const double r = a * (1 + beyond);
    const Precise xi = Precise(r) / Precise(a);
    const Precise tangent = sqrt(xi * xi - 1);
    const Precise t = atan(tangent);
    const Precise exact =
        Precise(hertz.approach()) / mpfr::const_pi() * (t * tangent * tangent + tangent - t);
    BOOST_TEST(static_cast<double>(abs(hertz.gap(r) / exact - 1)) < 1e-14);
  }
}

BOOST_AUTO_TEST_CASE(pressure_is_zero_from_the_edge_on) {
  BOOST_TEST(hertz.pressure(0) == hertz.peak_pressure());
  BOOST_TEST(hertz.pressure(a) == 0);
  BOOST_TEST(hertz.pressure(-2 * a) == 0);
}

BOOST_AUTO_TEST_CASE(bad_input_is_refused) {
  BOOST_CHECK_THROW(Hertz(0, 1, 1), InvalidQuantity);
  BOOST_CHECK_THROW(Hertz(1, -1, 1), InvalidQuantity);
  BOOST_CHECK_THROW(Hertz(1, 0, 1), InvalidQuantity);
  BOOST_CHECK_THROW(Hertz(1, 1, 0), InvalidQuantity);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(huber)

using point_contact::AxialStress;
using point_contact::Hertz;
using point_contact::Huber;
using sys::InvalidQuantity;

namespace {

const Hertz hertz(913.7, 0.571, 3.461);
constexpr double nu = 0.2385;
const Huber huber(hertz, nu);
const double a = hertz.radius();
const double p0 = hertz.peak_pressure();

// ∂/∂x by central differences with Richardson's extrapolation, in units of p₀/a.
template <class F>
double derivative(const F& f, double x) {
  const double step = 1e-3;
  const auto central = [&](double h) { return (f(x + h) - f(x - h)) / (2 * h); };
  return (4 * central(step / 2) - central(step)) / 3;
}

// A stress in units of p₀, lengths in units of a.
template <class Part>
double part(const Part& which, double r, double z) {
  return which(huber.stress(r * a, z * a)) / p0;
}

}  // namespace

BOOST_AUTO_TEST_CASE(stresses_on_the_axis_are_johnsons) {
  // Johnson 3.45a, b.
  for (const double z : {0.0, 0.1, 0.48, 2.0, 30.0}) {
    const double radial = -(1 + nu) * (1 - (z > 0 ? z * std::atan(1 / z) : 0)) + 0.5 / (1 + z * z);
    const AxialStress stress = huber.stress(0, z * a);
    BOOST_TEST(std::abs(stress.rr / p0 - radial) < 1e-14);
    BOOST_TEST(std::abs(stress.tt / p0 - radial) < 1e-14);
    BOOST_TEST(std::abs(stress.zz / p0 + 1 / (1 + z * z)) < 1e-14);
    BOOST_TEST(stress.rz == 0);
  }
}

BOOST_AUTO_TEST_CASE(stresses_on_the_surface_are_johnsons) {
  // Johnson 3.43 within, 3.44 outside the contact.
  for (const double r : {0.2, 0.7, 0.999}) {
    const double root = std::sqrt(1 - r * r);
    const double spread = (1 - 2 * nu) / (3 * r * r) * (1 - root * root * root);
    const AxialStress stress = huber.stress(r * a, 0);
    BOOST_TEST(std::abs(stress.zz / p0 + root) < 1e-14);
    BOOST_TEST(std::abs(stress.rr / p0 - (spread - root)) < 1e-13);
    BOOST_TEST(std::abs(stress.tt / p0 - (-spread - 2 * nu * root)) < 1e-13);
    BOOST_TEST(stress.rz == 0);
  }
  for (const double r : {1.0, 1.5, 20.0}) {
    const AxialStress stress = huber.stress(r * a, 0);
    BOOST_TEST(std::abs(stress.rr / p0 - (1 - 2 * nu) / (3 * r * r)) < 1e-7);
    BOOST_TEST(std::abs(stress.tt / p0 + (1 - 2 * nu) / (3 * r * r)) < 1e-7);
    BOOST_TEST(std::abs(stress.zz) < 1e-7 * p0);
  }
}

BOOST_AUTO_TEST_CASE(stresses_are_in_equilibrium) {
  const auto rr = [](const AxialStress& s) { return s.rr; };
  const auto tt = [](const AxialStress& s) { return s.tt; };
  const auto zz = [](const AxialStress& s) { return s.zz; };
  const auto rz = [](const AxialStress& s) { return s.rz; };
  for (const double r : {0.3, 0.9, 1.4}) {
    for (const double z : {0.2, 0.7, 3.0}) {
      const auto over_r = [&](const auto& which) {
        return derivative([&](double x) { return part(which, x, z); }, r);
      };
      const auto over_z = [&](const auto& which) {
        return derivative([&](double x) { return part(which, r, x); }, z);
      };
      const double radial = over_r(rr) + over_z(rz) + (part(rr, r, z) - part(tt, r, z)) / r;
      const double axial = over_r(rz) + over_z(zz) + part(rz, r, z) / r;
      BOOST_TEST(std::abs(radial) < 1e-9);
      BOOST_TEST(std::abs(axial) < 1e-9);
    }
  }
}

BOOST_AUTO_TEST_CASE(the_mean_stress_is_harmonic) {
  // Δ(σ_rr + σ_θθ + σ_zz) = 0: compatibility.
  const auto mean = [](double r, double z) {
    const AxialStress s = huber.stress(r * a, z * a);
    return (s.rr + s.tt + s.zz) / p0;
  };
  const double h = 0.01;
  for (const double r : {0.5, 1.3}) {
    for (const double z : {0.4, 1.1}) {
      const double laplacian =
          (mean(r + h, z) + mean(r - h, z) + mean(r, z + h) + mean(r, z - h) - 4 * mean(r, z)) /
              (h * h) +
          (mean(r + h, z) - mean(r - h, z)) / (2 * h * r);
      BOOST_TEST(std::abs(laplacian) < 2e-3);
    }
  }
}

BOOST_AUTO_TEST_CASE(every_depth_carries_the_load) {
  numerics::Quadrature quadrature;
  for (const double z : {0.1, 1.0}) {
    const auto ring = [&](double r) {
      return -2 * std::numbers::pi * r * huber.stress(r, z * a).zz;
    };
    // beyond 100 a: σ_zz = −3Pz³/(2πr⁵) of a force leaves P (z/r)³
    const double far = 100 * a;
    const double rest = hertz.load() * std::pow(z * a / far, 3);
    const double total =
        quadrature.adaptive(ring, 0, far, 1e-9 * hertz.load(), {"the load", z}).value + rest;
    BOOST_TEST(std::abs(total / hertz.load() - 1) < 1e-7);
  }
}

BOOST_AUTO_TEST_CASE(the_greatest_shear_lies_where_johnson_says) {
  // ν = 0.3: 0.310 p₀ at z = 0.48 a (Johnson, p. 95).
  const Huber steel(hertz, 0.3);
  double greatest = 0;
  double depth = 0;
  for (double z = 0.3; z < 0.7; z += 1e-4) {
    const AxialStress stress = steel.stress(0, z * a);
    const double shear = std::abs(stress.zz - stress.rr) / 2;
    if (shear <= greatest) continue;
    greatest = shear;
    depth = z;
  }
  BOOST_TEST(std::abs(greatest / p0 - 0.310) < 5e-4);
  BOOST_TEST(std::abs(depth - 0.48) < 5e-3);
}

BOOST_AUTO_TEST_CASE(far_away_the_contact_is_a_force) {
  // σ_zz = −3P z³/(2π ρ⁵) (Johnson 3.19).
  const double r = 300 * a;
  const double z = 400 * a;
  const double boussinesq =
      -3 * hertz.load() / (2 * std::numbers::pi) * std::pow(z, 3) / std::pow(std::hypot(r, z), 5);
  BOOST_TEST(std::abs(huber.stress(r, z).zz / boussinesq - 1) < 1e-4);
}

BOOST_AUTO_TEST_CASE(bad_input_is_refused) {
  BOOST_CHECK_THROW(huber.stress(0, -1), InvalidQuantity);
  BOOST_CHECK_THROW(huber.stress(std::nan(""), 1), InvalidQuantity);
  BOOST_CHECK_THROW(Huber(hertz, 0.51), InvalidQuantity);
  BOOST_CHECK_THROW(Huber(hertz, -1), InvalidQuantity);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE_END()
