// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "block/rectangle.hpp"
#include "block/solution.hpp"
#include "elasticity/material.hpp"

namespace block_tests {

/// The exact solution of the block with roller sides and a clamped bottom, W = width/2.
///
/// Its even pressure is p₀ + Σ pₙ cos kₙx, kₙ = nπ/W. To each term belongs Airy's function f(z) cos
/// kx with f = (A + Bkz) e^{−kz} + [C + Dk(H − z)] e^{−k(H−z)}, whose displacements, of plane
/// strain,
///
///   2μk u_x = [(1−ν) f″ + νk² f] sin kx,    2μk² u_z = [(1−ν) f‴ − (2−ν)k² f′] cos kx,
///
/// have no u_x and no shear on x = ±W. A … D follow from k²f = pₙ and f′ = 0 at z = 0, u = 0 at z =
/// H.
class CosineSeries {
 public:
  /// `coefficient(k)` is pₙ for k > 0, and p₀ for k = 0.
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

  /// ½∫ p u_z dx.
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

}  // namespace block_tests
