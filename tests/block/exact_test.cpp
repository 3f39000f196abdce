// SPDX-License-Identifier: GPL-3.0-or-later
// The block compared with exact solutions: cosine series and states of uniform stress.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>

#include "block/cosine_series.hpp"
#include "block/paper_block.hpp"

BOOST_AUTO_TEST_SUITE(exact_test)

using block::Support;
using block_tests::CosineSeries;
using numerics::Estimate;
using paper_block::measure;

namespace {

const block::Supports rollers = block::with_sides(Support::roller);

// A pressure that falls linearly from its peak to an edge.
struct Fall {
  double peak, edge, half_width;

  elasticity::Load load() const { return elasticity::LinearFall(peak, edge / peak, half_width); }

  // The coefficient of cos kx on |x| < width/2.
  double coefficient(double width, double k) const {
    const double a = half_width;
    if (k == 0) return a * (peak + edge) / width;
    return 4 / width *
           (edge * std::sin(k * a) / k + (peak - edge) * (1 - std::cos(k * a)) / (a * k * k));
  }
};

CosineSeries series(const block::Rectangle& rectangle, const elasticity::Material& material,
                    const Fall& fall) {
  return {rectangle, material, [&](double k) { return fall.coefficient(rectangle.width(), k); },
          100'000};
}

void check(const Estimate& computed, double exact, double unit) {
  BOOST_TEST(std::abs(computed.value - exact) <= computed.abs_error + 1e-9 * unit);
  BOOST_TEST(computed.abs_error < 3e-3 * unit);
}

const Fall falls[] = {{1000, 0, 0.01}, {1000, 600, 0.01}, {1000, 1000, 0.01}};

}  // namespace

BOOST_AUTO_TEST_CASE(displacements_and_energy_on_rollers_are_exact_within_their_errors) {
  for (const Fall& fall : falls) {
    const CosineSeries exact = series(paper_block::rectangle, paper_block::material, fall);
    const auto solution = paper_block::solve(fall.load(), rollers);
    const double unit = exact.at(0, 0).displacement.y();
    for (const double x : {0.0, 0.003, 0.01, -0.017, 0.05, 0.7, 1.0}) {
      for (const double z : {0.0, 0.004, 0.3}) {
        check(solution.displacement_z(x, z), exact.at(x, z).displacement.y(), unit);
      }
    }
    const double energy = exact.strain_energy();
    check(measure(solution.measures(), "strain_energy"), energy, energy);
  }
}

BOOST_AUTO_TEST_CASE(greatest_stresses_and_displacements_on_rollers_are_exact_within_their_errors) {
  // Maxima of the series with 400,000 terms under the fall from 1000 to 600; at the kinks, where
  // σ_xx (0, 0) and u_x (−a, 0) are greatest, extrapolated from 50,000, 100,000 and 400,000 terms
  const auto measures = paper_block::solve(falls[1].load(), rollers).measures();

  check(measure(measures, "max_stress_vm"), 529.187451, 1000);
  check(measure(measures, "max_stress_xy"), -237.982125, 1000);
  check(measure(measures, "max_stress_yy"), -1000, 1000);
  check(measure(measures, "max_stress_xx"), -994.0939, 1000);
  check(measure(measures, "max_disp_x"), 1.368752e-7, 1e-6);
}

BOOST_AUTO_TEST_CASE(stresses_inside_a_block_of_different_material_and_shape_are_exact) {
  const block::Rectangle rectangle(5, 1.3);
  const elasticity::Material rubber(7, 0.47);
  const Fall wide{3, 1, 0.4};
  const CosineSeries exact = series(rectangle, rubber, wide);
  const elasticity::Load load = wide.load();
  const block::Solution solution =
      block::Analysis(rectangle, rubber, {load}, {9, 2}).on(rollers).solve(load).fine();
  for (const double x : {-2.3, -0.4, 0.0, 0.11, 1.7}) {
    for (const double z : {0.1, 0.4, 0.9, 1.29}) {
      const block::PointState computed = solution.at(x, z);
      const block::PointState expected = exact.at(x, z);
      BOOST_TEST((computed.displacement - expected.displacement).norm() < 1e-6);
      BOOST_TEST(std::abs(computed.stress.xx - expected.stress.xx) < 1e-4);
      BOOST_TEST(std::abs(computed.stress.zz - expected.stress.zz) < 1e-4);
      BOOST_TEST(std::abs(computed.stress.xz - expected.stress.xz) < 1e-4);
    }
  }
}

BOOST_AUTO_TEST_CASE(uniform_pressure_strains_a_free_block_and_one_between_rollers_uniformly) {
  const double young = 2.385e5, nu = 0.317, pressure = 71.5;
  const elasticity::Material material(young, nu);
  const auto load = elasticity::distributed_load([=](double) { return pressure; }, {-1, 1.3});
  for (int order = 1; order <= 10; ++order) {
    // Elements with aspect ratios up to 60
    const auto model = std::make_shared<const block::Model>(
        block::Mesh(order, {-1, -0.31, 0.02, 0.07, 1.3}, {0, 0.02, 0.33, 1.1}), material);
    for (const Support right : {Support::free, Support::roller}) {
      const block::Solution solution =
          block::Factorization(model, {Support::roller, right, Support::roller}).solve(load);

      const double side = right == Support::free ? 0 : -pressure * nu / (1 - nu);
      const double e_zz = ((1 - nu * nu) * -pressure - nu * (1 + nu) * side) / young;
      const double e_xx = ((1 - nu * nu) * side + nu * (1 + nu) * pressure) / young;
      for (const double x : {-0.9, 0.033, 1.2}) {
        for (const double z : {0.0, 0.017, 0.6}) {
          const block::PointState state = solution.at(x, z);
          BOOST_TEST(std::abs(state.displacement.x() - e_xx * (x + 1)) < 1e-14);
          BOOST_TEST(std::abs(state.displacement.y() - e_zz * (z - 1.1)) < 1e-14);
          BOOST_TEST(std::abs(state.stress.zz + pressure) < 1e-7);
          BOOST_TEST(std::abs(state.stress.xx - side) < 1e-7);
          BOOST_TEST(std::abs(state.stress.xz) < 1e-7);
        }
      }
      BOOST_TEST((solution.applied() - Eigen::Vector2d(0, 2.3 * pressure)).norm() < 1e-10);
      BOOST_TEST(std::abs(solution.reaction().y() + 2.3 * pressure) < 1e-8);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_large_block_is_a_half_space_on_any_support) {
  // The supports bend the surface under the load by a curvature like 1/size²
  const elasticity::TriangularLoad triangle(1000, paper_block::half_width);
  const elasticity::Load load = triangle;
  const block::Analysis analysis({128, 64}, paper_block::material, {load}, {8, 1});
  for (const Support sides : {Support::clamped, Support::roller, Support::free}) {
    const block::RefinedSolution solution = analysis.on(block::with_sides(sides)).solve(load);
    const auto drop = [&](double x) {
      return (solution.displacement_z(0, 0) - solution.displacement_z(x, 0)).value;
    };
    const auto exact = [&](double x) {
      return normal_displacement(paper_block::material, triangle, 0, 10) -
             normal_displacement(paper_block::material, triangle, x, 10);
    };
    for (const double x : {0.005, 0.01, 0.02, 0.05}) {
      BOOST_TEST(std::abs(drop(x) / exact(x) - 1) < 2e-6);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
