// SPDX-License-Identifier: GPL-3.0-or-later
#include "elasticity/surface_quadrature.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "elasticity/loads.hpp"
#include "numbers.hpp"

BOOST_AUTO_TEST_SUITE(surface_quadrature_test)

using elasticity::Load;
using elasticity::Material;
using elasticity::SurfaceQuadrature;
using elasticity::TriangularLoad;
using elasticity::UniformLoad;
using numerics::Estimate;
using std::numbers::pi;

namespace {

// The difference is below the reported error, which is at most 1e-10 of the unit.
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

BOOST_AUTO_TEST_CASE(gradient_and_displacement_by_equation_2_agree_with_equation_3_even_at_kinks) {
  RandomInputs random(31);
  for (int i = 0; i < 100; ++i) {
    const RandomCase c(random);
    const SurfaceQuadrature surface(c.material, c.load, c.datum);
    for (int j = 0; j < 40; ++j) {
      const double share = j < 3 ? j - 1 : random.point(1e6);
      const double x = c.load.half_width() * share;
      check(surface.normal_gradient(x), normal_gradient(c.material, c.load, x), c.gradient_unit(),
            share);
      check(surface.normal_displacement(x), normal_displacement(c.material, c.load, x, c.datum),
            c.displacement_unit(), share);
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

BOOST_AUTO_TEST_CASE(an_elliptic_pressure_displaces_the_surface_beneath_it_to_a_parabola) {
  // Hertz: p = p₀ √(1 − x²/a²) gives ∂u_z/∂x = −2(1−ν²) p₀ x/(E a) inside (Johnson 4.42).
  const Material steel(207e3, 0.29);
  const double p0 = 830;
  const double a = 0.125;
  const auto pressure = [=](double s) { return p0 * std::sqrt((1 - s / a) * (1 + s / a)); };
  const SurfaceQuadrature surface(steel, elasticity::distributed_load(pressure, {-a, a}), 10);
  const double unit = steel.integral_compliance() * p0;
  for (const double x : {-0.1, -0.0123, 0.0, 0.004, 0.07, 0.1249}) {
    check(surface.normal_gradient(x), -unit * pi * x / a, unit, x);
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
    BOOST_TEST(surface.tangential_gradient(x).value == tangential_gradient(steel, load, x));
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

namespace {

// p = 0.5 + amplitude·shape((s − centre)/width) on |s| ≤ 1, E = 1, ν = 0, u_z = 0 at 10.
struct Narrow {
  double (*shape)(double t);
  double centre, width, amplitude;
  double x;
  double gradient, displacement;
};

double gauss(double t) {
  return std::exp(-t * t);
}
double lorentz(double t) {
  return 1 / (1 + t * t);
}
double step(double t) {
  return (1 + std::tanh(t)) / 2;
}
double hat(double t) {
  return std::max(0.0, 1 - std::abs(t));
}
double cusp(double t) {
  return std::exp(-std::abs(t));
}

// By mpmath with 30 digits, mp.quad split at the centre ± 0, 1, 2, 4 … 128 widths and at x:
//   u = 2/π ∫ p(s) ln((10−s)/|x−s|) ds,
//   ∂u/∂x = −2/π [∫ (p(s)−p(x))/(x−s) ds + p(x) ln((x+1)/(1−x))], p(x) = 0 outside
const Narrow narrow_loads[] = {
    {gauss, 0.608, 0.0103, -0.3, 2.0, -0.3471942767866387, 1.045672733234185},
    {lorentz, -0.529, 0.0191, 0.01, 0.182, -0.1177050585229216, 2.091843592740378},
    {step, 0.031, 0.0029, 0.5, 0.03097, 2.090759258490915, 3.112969177852979},
    {hat, -0.154, 0.0186, 0.5, 2.0, -0.3524478236259162, 1.061509394122264},
    {cusp, 0.421, 0.016, -0.3, -0.965, 1.277709554826546, 1.704453878527642},
    {gauss, 0.837, 0.0115, -0.3, 0.82595, -1.114010490053899, 1.821225951318398},
    {lorentz, 0.331, 0.0185, 0.5, 2.0, -0.3606517805862176, 1.084395396262191},
    {step, 0.534, 0.0044, 0.01, 1.446, -0.5462823423586582, 1.298191436075219},
    {hat, -0.862, 0.0092, 0.5, -0.85543, 0.2513058980665265, 1.847801142297728},
    {cusp, 0.419, 0.0057, 0.01, 2.0, -0.3497450580316107, 1.052460041572492},
    {gauss, 0.236, 0.0057, 0.01, 1.497, -0.5138844151786911, 1.263618785085819},
    {lorentz, 0.297, 0.0051, 0.01, 0.30169, -0.2081943570577214, 2.072737300745518},
    {step, 0.349, 0.014, 0.5, 2.0, -0.5092843205388535, 1.458673789776291},
    {hat, -0.753, 0.0026, -0.3, 0.332, -0.2192234844266796, 2.064527667358972},
    {cusp, -0.494, 0.0036, -0.3, -0.48809, 0.5579263632821277, 2.011756889141962},
    {gauss, -0.11, 0.0116, -0.3, 2.0, -0.3478381009806317, 1.046176660337048},
    {lorentz, -0.096, 0.0077, 0.5, 0.594, -0.4465007685104535, 2.001959848256301},
    {step, 0.255, 0.0095, 0.5, 0.25514, 1.482908155384678, 2.91826197983437},
    {hat, 0.168, 0.0054, 0.5, 2.0, -0.350637403589218, 1.055217392016192},
    {cusp, 0.077, 0.0045, -0.3, -0.367, 0.2411957354955769, 2.052195196263675},
    {gauss, -0.697, 0.002, -0.3, -0.69692, 0.5753643510206833, 1.924479607406191},
    {lorentz, 0.179, 0.0099, 0.5, 2.0, -0.3551071003992756, 1.068907263063962},
    {step, 0.471, 0.0057, 0.01, 1.345, -0.6159572059617813, 1.357657626660933},
    {hat, -0.781, 0.0085, -0.3, -0.78506, 0.364030445620795, 1.864152578845638},
    {cusp, 0.29, 0.0049, 0.01, 2.0, -0.3497356378072001, 1.052437629832113},
    {hat, -0.98954391873846645, 0.008991357955426629, 0.5, 2.0, -0.3506565034262855,
     1.056055151411763},
};

}  // namespace

BOOST_AUTO_TEST_CASE(the_error_bound_holds_for_a_load_with_a_narrow_feature) {
  for (const Narrow& n : narrow_loads) {
    const auto pressure = [&](double s) {
      return 0.5 + n.amplitude * n.shape((s - n.centre) / n.width);
    };
    const SurfaceQuadrature surface(Material(1, 0), elasticity::distributed_load(pressure, {-1, 1}),
                                    10);
    check(surface.normal_gradient(n.x), n.gradient, 1, n.x);
    check(surface.normal_displacement(n.x), n.displacement, 1, n.x);
  }
}

BOOST_AUTO_TEST_SUITE_END()
