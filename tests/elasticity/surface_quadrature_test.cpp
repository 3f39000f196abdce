// SPDX-License-Identifier: GPL-3.0-or-later
#include "elasticity/surface_quadrature.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "elasticity/concentrated_load.hpp"
#include "elasticity/load_shapes.hpp"
#include "elasticity/triangular_load.hpp"
#include "random_inputs.hpp"
#include "system/require.hpp"
#include "tolerances.hpp"

BOOST_AUTO_TEST_SUITE(surface_quadrature_test)

using elasticity::Load;
using elasticity::Material;
using elasticity::SurfaceQuadrature;
using elasticity::TriangularLoad;
using elasticity::UniformLoad;
using numerics::Estimate;
using std::numbers::pi;
using sys::InvalidQuantity;

namespace {

// The difference is below the reported error, and that is at most 1e-10 of the unit.
void check(const Estimate& estimate, double exact, double unit, double x) {
  BOOST_TEST_CONTEXT("x = " << x) {
    const double rounding_of_closed_form = tolerance::displacement * unit;
    BOOST_TEST(std::abs(estimate.value - exact) <= estimate.abs_error + rounding_of_closed_form);
    BOOST_TEST(estimate.abs_error <= tolerance::quadrature * unit);
  }
}

struct RandomCase {
  explicit RandomCase(RandomInputs& random)
      : material(random.log_uniform(1, 1e12), random.uniform(-0.99, 0.49)),
        load(random.log_uniform(1e-3, 1e9), random.log_uniform(1e-6, 1e3)),
        datum(load.half_width() * random.log_uniform(1, 1e4)) {}

  double displacement_unit() const { return material.integral_compliance() * load.line_load(); }
  double gradient_unit() const { return displacement_unit() / load.half_width(); }

  Material material;
  TriangularLoad load;
  double datum;
};

}  // namespace

BOOST_AUTO_TEST_CASE(gradient_by_equation_2_agrees_with_the_derivative_of_equation_3) {
  RandomInputs random(31);
  for (int i = 0; i < 100; ++i) {
    const RandomCase c(random);
    const SurfaceQuadrature surface(c.material, c.load, c.datum);
    for (int j = 0; j < 40; ++j) {
      const double x = c.load.half_width() * random.point(1e6);
      check(surface.normal_gradient(x), normal_gradient(c.material, c.load, x), c.gradient_unit(),
            x / c.load.half_width());
    }
  }
}

BOOST_AUTO_TEST_CASE(displacement_by_the_logarithmic_kernel_agrees_with_equation_3) {
  RandomInputs random(32);
  for (int i = 0; i < 100; ++i) {
    const RandomCase c(random);
    const SurfaceQuadrature surface(c.material, c.load, c.datum);
    for (int j = 0; j < 40; ++j) {
      const double x = c.load.half_width() * random.point(1e6);
      check(surface.normal_displacement(x), normal_displacement(c.material, c.load, x, c.datum),
            c.displacement_unit(), x / c.load.half_width());
    }
  }
}

BOOST_AUTO_TEST_CASE(displacement_by_integrating_equation_2_agrees_with_equation_3) {
  RandomInputs random(33);
  for (int i = 0; i < 30; ++i) {
    const RandomCase c(random);
    const SurfaceQuadrature surface(c.material, c.load, c.datum);
    for (int j = 0; j < 10; ++j) {
      const double x = c.load.half_width() * random.point(1e4);
      check(surface.normal_displacement_from_gradient(x),
            normal_displacement(c.material, c.load, x, c.datum), c.displacement_unit(),
            x / c.load.half_width());
    }
  }
}

BOOST_AUTO_TEST_CASE(the_kinks_themselves_are_points_like_any_other) {
  const Material steel(30e6, 0.3);
  const TriangularLoad load(1000, 0.01);
  const SurfaceQuadrature surface(steel, load, 10);
  const double unit = steel.integral_compliance() * load.line_load();
  for (const double x : {0.0, 0.01, -0.01}) {
    check(surface.normal_gradient(x), normal_gradient(steel, load, x), unit / 0.01, x);
    check(surface.normal_displacement(x), normal_displacement(steel, load, x, 10), unit, x);
    check(surface.normal_displacement_from_gradient(x), normal_displacement(steel, load, x, 10),
          unit, x);
  }
}

BOOST_AUTO_TEST_CASE(a_uniform_load_agrees_with_its_closed_form_between_its_jumps) {
  RandomInputs random(34);
  const Material steel(207e3, 0.29);
  const UniformLoad load(2.385, 0.75);
  const SurfaceQuadrature surface(steel, load, 100);
  const double unit = steel.integral_compliance() * load.line_load();
  for (int i = 0; i < 400; ++i) {
    const double x = 0.75 * random.point(1e4);
    if (std::abs(x) == 0.75) continue;
    check(surface.normal_gradient(x), normal_gradient(steel, load, x), unit / 0.75, x);
    check(surface.normal_displacement(x), normal_displacement(steel, load, x, 100), unit, x);
  }
  check(surface.normal_displacement(0.75), normal_displacement(steel, load, 0.75, 100), unit, 0.75);
  check(surface.normal_displacement_from_gradient(0.1), normal_displacement(steel, load, 0.1, 100),
        unit, 0.1);
}

BOOST_AUTO_TEST_CASE(an_elliptic_pressure_makes_a_parabola_under_itself) {
  // Hertz: p = p₀ √(1 − x²/a²) gives ∂u_z/∂x = −2(1−ν²) p₀ x/(E a) inside (Johnson 4.42).
  const Material steel(207e3, 0.29);
  const double p0 = 830;
  const double a = 0.125;
  const auto pressure = [=](double s) { return p0 * std::sqrt((1 - s / a) * (1 + s / a)); };
  const SurfaceQuadrature surface(steel, elasticity::distributed_load(pressure, nullptr, {-a, a}),
                                  10);
  const double unit = steel.integral_compliance() * p0;
  for (const double x : {-0.1, -0.0123, 0.0, 0.004, 0.07, 0.1249}) {
    check(surface.normal_gradient(x), -unit * pi * x / a, unit, x);
  }
}

BOOST_AUTO_TEST_CASE(friction_adds_its_local_term_to_the_gradient) {
  // Sliding: q = μp. The normal gradient gains (1−2ν)(1+ν)q/E and u_x the Cauchy integral of q.
  const Material rubber(5, 0.4);
  const double mu = 0.3;
  const auto pressure = [](double s) { return 2 - s * s; };
  const auto shear = [&](double s) { return mu * pressure(s); };
  const std::vector<double> ends = {-1, 1};
  const SurfaceQuadrature with(rubber, elasticity::distributed_load(pressure, shear, ends), 10);
  const SurfaceQuadrature without(rubber, elasticity::distributed_load(pressure, nullptr, ends),
                                  10);
  for (const double x : {-0.7, 0.1, 0.93}) {
    const double gain = with.normal_gradient(x).value - without.normal_gradient(x).value;
    const double stretch = with.tangential_gradient(x).value - without.tangential_gradient(x).value;
    BOOST_TEST(tolerance::relative_difference(gain, rubber.local_compliance() * shear(x)) < 1e-12);
    BOOST_TEST(tolerance::relative_difference(stretch, mu * without.normal_gradient(x).value) <
               1e-12);
  }
}

BOOST_AUTO_TEST_CASE(with_friction_the_two_routes_to_the_displacement_still_agree) {
  const Material rubber(5, 0.4);
  const auto pressure = [](double s) { return 1 - s * s; };
  const auto shear = [](double s) { return 0.3 * (1 - s * s) * (2 + s); };
  const SurfaceQuadrature surface(rubber,
                                  elasticity::distributed_load(pressure, shear, {-1, 0.25, 1}), 20);
  const double unit = rubber.integral_compliance() * 4 / 3;
  for (const double x : {-3.0, -1.0, -0.4, 0.25, 0.9, 2.0}) {
    const Estimate direct = surface.normal_displacement(x);
    check(surface.normal_displacement_from_gradient(x), direct.value, unit, x);
  }
}

BOOST_AUTO_TEST_CASE(tangential_displacement_of_a_triangle_agrees_with_its_closed_form) {
  RandomInputs random(35);
  const Material steel(30e6, 0.3);
  const TriangularLoad load(1000, 0.01);
  const SurfaceQuadrature surface(steel, load, 10);
  const double unit = steel.local_compliance() * load.line_load();
  for (int i = 0; i < 200; ++i) {
    const double x = 0.01 * random.point(1e3);
    check(surface.tangential_displacement(x), tangential_displacement(steel, load, x), unit, x);
    check(surface.tangential_gradient(x), tangential_gradient(steel, load, x), unit / 0.01, x);
  }
}

BOOST_AUTO_TEST_CASE(a_concentrated_force_agrees_with_its_closed_form) {
  const Material steel(30e6, 0.3);
  const elasticity::ConcentratedLoad load(10);
  const SurfaceQuadrature surface(steel, load, 10);
  const double unit = steel.integral_compliance() * 10;
  for (const double x : {-2.0, 1e-6, 0.3, 50.0}) {
    check(surface.normal_gradient(x), normal_gradient(steel, load, x), unit / std::abs(x), x);
    check(surface.normal_displacement(x), normal_displacement(steel, load, x, 10), 30 * unit, x);
    const double side = -std::copysign(steel.local_compliance() / 2 * 10, x);
    check(surface.tangential_displacement(x), side, unit, x);
  }
  check(surface.normal_displacement_from_gradient(0.3), normal_displacement(steel, load, 0.3, 10),
        unit, 0.3);
}

BOOST_AUTO_TEST_CASE(where_the_answer_is_infinite_there_is_none) {
  const Material steel(30e6, 0.3);
  const SurfaceQuadrature uniform(steel, UniformLoad(1, 1), 10);
  const SurfaceQuadrature point(steel, elasticity::ConcentratedLoad(1), 10);

  BOOST_CHECK_THROW(uniform.normal_gradient(1), InvalidQuantity);
  BOOST_CHECK_THROW(point.normal_gradient(0), InvalidQuantity);
  BOOST_CHECK_THROW(point.normal_displacement(0), InvalidQuantity);
  BOOST_CHECK_THROW(point.normal_displacement_from_gradient(-1), InvalidQuantity);
  BOOST_CHECK_THROW(SurfaceQuadrature(steel, elasticity::ConcentratedLoad(1), 0), InvalidQuantity);
}

BOOST_AUTO_TEST_CASE(points_and_data_must_be_finite) {
  const Material steel(30e6, 0.3);
  const double infinity = std::numeric_limits<double>::infinity();
  const SurfaceQuadrature surface(steel, TriangularLoad(1, 1), 10);

  BOOST_CHECK_THROW(SurfaceQuadrature(steel, TriangularLoad(1, 1), infinity), InvalidQuantity);
  BOOST_CHECK_THROW(surface.normal_gradient(NAN), InvalidQuantity);
  BOOST_CHECK_THROW(surface.normal_displacement(infinity), InvalidQuantity);
  BOOST_CHECK_THROW(surface.normal_displacement_from_gradient(infinity), InvalidQuantity);
}

BOOST_AUTO_TEST_CASE(a_shear_moves_the_surface_along_as_a_pressure_of_its_shape_moves_it_down) {
  // Johnson (2.24): q enters u_x as p enters u_z, and both are zero at the datum.
  RandomInputs random(37);
  const Material steel(30e6, 0.3);
  const TriangularLoad triangle(1000, 0.01);
  Load shear;
  shear.tangential = Load(triangle).normal;
  const double unit = steel.integral_compliance() * triangle.line_load();
  for (const double datum : {10.0, 0.02}) {
    const SurfaceQuadrature surface(steel, shear, datum);
    for (int i = 0; i < 100; ++i) {
      const double x = 0.01 * random.point(1e3);
      check(surface.tangential_displacement(x), normal_displacement(steel, triangle, x, datum),
            unit, x);
      check(surface.tangential_gradient(x), normal_gradient(steel, triangle, x), unit / 0.01, x);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
