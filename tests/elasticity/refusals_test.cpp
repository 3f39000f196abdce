// SPDX-License-Identifier: GPL-3.0-or-later
#include "refused.hpp"

#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>

#include "elasticity/loads.hpp"
#include "elasticity/stress.hpp"
#include "elasticity/surface_quadrature.hpp"

BOOST_AUTO_TEST_SUITE(refusals_test)

using elasticity::ConcentratedLoad;
using elasticity::distributed_load;
using elasticity::LinearFall;
using elasticity::Material;
using elasticity::stress_beneath;
using elasticity::SurfaceQuadrature;
using elasticity::TriangularLoad;
using elasticity::UniformLoad;

BOOST_AUTO_TEST_CASE(invalid_input_is_rejected_by_name) {
  const double infinity = std::numeric_limits<double>::infinity();
  const Material steel(30e6, 0.3);
  const TriangularLoad triangle(1, 1);
  const auto constant = [](double) { return 1.0; };
  const auto punch = [](double s) { return 1 / std::sqrt(1 - s * s); };
  const std::array nodes = {-1.0, 0.5, 2.0};
  const std::array pressures = {0.0, 1.0, 1.0};
  const SurfaceQuadrature under_triangle(steel, triangle, 10);
  const SurfaceQuadrature under_uniform(steel, UniformLoad(1, 1), 10);
  const SurfaceQuadrature under_force(steel, ConcentratedLoad(1), 10);

  check_refused({
      {"young", [] { Material(0, 0.3); }},
      {"young", [&] { Material(infinity, 0.3); }},
      {"poisson = 0.5", [] { Material(30e6, 0.5); }},
      {"poisson = -1", [] { Material(30e6, -1); }},
      {"poisson = nan", [] { Material(30e6, NAN); }},
      {"peak_pressure", [] { TriangularLoad(0, 1); }},
      {"half_width = -1", [] { UniformLoad(1, -1); }},
      {"line_load", [] { ConcentratedLoad(0); }},
      {"edge_fraction", [] { LinearFall(1, -0.1, 1); }},
      {"x = inf", [&] { normal_gradient(steel, triangle, infinity); }},
      {"x = nan", [&] { normal_displacement(steel, triangle, NAN, 1); }},
      {"datum", [&] { normal_displacement(steel, triangle, 0, infinity); }},
      {"away from the edge", [&] { normal_gradient(steel, UniformLoad(1, 2.385), -2.385); }},
      {"away from the concentrated force", [&] { normal_gradient(steel, ConcentratedLoad(1), 0); }},
      {"datum", [&] { normal_displacement(steel, ConcentratedLoad(1), 1, 0); }},
      {"breakpoints = 1", [&] { distributed_load(constant, {1}); }},
      {"end of a piece",
       [&] {
         distributed_load(constant, {0, 1, 0.5});
       }},
      {"value of a piece",
       [&] {
         distributed_load(punch, {-1, 1});
       }},
      {"nodes = 1",
       [&] {
         stress_beneath({nodes.data(), 1}, {pressures.data(), 1}, 0, 1);
       }},
      {"nodes = 3",
       [&] {
         stress_beneath(nodes, {pressures.data(), 2}, 0, 1);
       }},
      {"node",
       [&] {
         stress_beneath(std::array{0.0, 0.0}, std::array{1.0, 1.0}, 0, 1);
       }},
      {"pressure",
       [&] {
         stress_beneath(std::array{0.0, 1.0}, std::array{1.0, infinity}, 0, 1);
       }},
      {"z = -1", [&] { stress_beneath(nodes, pressures, 0, -1); }},
      {"x = nan", [&] { stress_beneath(nodes, pressures, NAN, 1); }},
      {"away from the jump", [&] { stress_beneath(nodes, pressures, 2, 0); }},
      {"poisson = 0.6",
       [] {
         elasticity::Stress{1, 2, 3}.von_mises(0.6);
       }},
      {"datum", [&] { SurfaceQuadrature(steel, triangle, infinity); }},
      {"away from the concentrated force",
       [&] { SurfaceQuadrature(steel, ConcentratedLoad(1), 0); }},
      {"x", [&] { under_triangle.normal_gradient(NAN); }},
      {"x", [&] { under_triangle.normal_displacement(infinity); }},
      {"x", [&] { under_triangle.normal_displacement_from_gradient(infinity); }},
      {"away from the jump", [&] { under_uniform.normal_gradient(1); }},
      {"away from the concentrated force", [&] { under_force.normal_gradient(0); }},
      {"away from the concentrated force", [&] { under_force.normal_displacement(0); }},
      {"away from the concentrated force",
       [&] { under_force.normal_displacement_from_gradient(-1); }},
  });
}

BOOST_AUTO_TEST_SUITE_END()
