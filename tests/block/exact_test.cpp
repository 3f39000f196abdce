// SPDX-License-Identifier: GPL-3.0-or-later
#include <boost/test/unit_test.hpp>

#include <Eigen/Dense>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "block/paper_block.hpp"

BOOST_AUTO_TEST_SUITE(exact_test)

using block::Support;
using numerics::Estimate;
using paper_block::measure;

namespace {

// The exact solution of the block with roller sides and a clamped bottom, W = width/2.
//
// Its even pressure is p₀ + Σ pₙ cos kₙx, kₙ = nπ/W. To each term belongs Airy's function f(z) cos
// kx with f = (A + Bkz) e^{−kz} + [C + Dk(H − z)] e^{−k(H−z)}, whose displacements, of plane
// strain,
//
//   2μk u_x = [(1−ν) f″ + νk² f] sin kx,    2μk² u_z = [(1−ν) f‴ − (2−ν)k² f′] cos kx,
//
// have no u_x and no shear on x = ±W. A … D follow from k²f = pₙ and f′ = 0 at z = 0, u = 0 at z =
// H.
class CosineSeries {
 public:
  // `coefficient(k)` is pₙ for k > 0, and p₀ for k = 0.
  CosineSeries(const block::Rectangle& block, const elasticity::Material& material,
               const std::function<double(double)>& coefficient, int n_terms)
      : height_(block.height()),
        width_(block.width()),
        nu_(material.poisson()),
        mu_(material.young() / (2 * (1 + nu_))),
        mean_(coefficient(0)) {
    for (int n = 1; n <= n_terms; ++n) {
      const double k = 2 * n * std::numbers::pi / width_;
      Eigen::Matrix4d rows;
      for (int i = 0; i < 4; ++i) {
        const auto top = derivatives(Eigen::Vector4d::Unit(i), k, 0);
        const auto bottom = derivatives(Eigen::Vector4d::Unit(i), k, height_);
        rows.col(i) << top[0], top[1], (1 - nu_) * bottom[2] + nu_ * bottom[0],
            (1 - nu_) * bottom[3] - (2 - nu_) * bottom[1];
      }
      const double p = coefficient(k);
      terms_.push_back({k, p, rows.partialPivLu().solve(Eigen::Vector4d(p / (k * k), 0, 0, 0))});
    }
  }

  block::PointState at(double x, double z) const {
    const double side = -nu_ / (1 - nu_) * mean_;
    block::PointState s{{x, z},
                        {0, mean_ * (1 - 2 * nu_) / (2 * mu_ * (1 - nu_)) * (height_ - z)},
                        {side, -mean_, 0}};
    for (const auto& [k, p, c] : terms_) {
      if (k * z > 45 && k * (height_ - z) > 45) break;
      const Eigen::Vector4d f = k * k * derivatives(c, k, z);
      const double cosine = std::cos(k * x), sine = std::sin(k * x);
      s.displacement.x() += ((1 - nu_) * f[2] + nu_ * f[0]) * sine / (2 * mu_ * k);
      s.displacement.y() += ((1 - nu_) * f[3] - (2 - nu_) * f[1]) * cosine / (2 * mu_ * k);
      s.stress += {f[2] * cosine, -f[0] * cosine, f[1] * sine};
    }
    return s;
  }

  // ½∫ p u_z dx.
  double strain_energy() const {
    double sum = width_ * mean_ * mean_ * (1 - 2 * nu_) / (2 * mu_ * (1 - nu_)) * height_;
    for (const auto& [k, p, c] : terms_) {
      const Eigen::Vector4d f = k * k * derivatives(c, k, 0);
      sum += width_ / 2 * p * ((1 - nu_) * f[3] - (2 - nu_) * f[1]) / (2 * mu_ * k);
    }
    return sum / 2;
  }

 private:
  // f, f′/k, f″/k² and f‴/k³.
  Eigen::Vector4d derivatives(const Eigen::Vector4d& c, double k, double z) const {
    const double down = std::exp(-k * z), up = std::exp(-k * (height_ - z));
    const double a = c[0] + c[1] * k * z, b = c[2] + c[3] * k * (height_ - z);
    return {a * down + b * up, (c[1] - a) * down + (b - c[3]) * up,
            (a - 2 * c[1]) * down + (b - 2 * c[3]) * up,
            (3 * c[1] - a) * down + (b - 3 * c[3]) * up};
  }

  struct Term {
    double k, p;
    Eigen::Vector4d c;
  };
  double height_, width_, nu_, mu_, mean_;
  std::vector<Term> terms_;
};

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
