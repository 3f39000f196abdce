// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/load_fit.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "elasticity/loads.hpp"
#include "elasticity/stress.hpp"
#include "numerics/fit.hpp"
#include "paper/conventions.hpp"

namespace paper {
namespace {

constexpr int n_pieces = 80;

}  // namespace

FallingPressure::FallingPressure(const std::function<double(double)>& f, double middle, double end,
                                 double half_width)
    : f_(f), middle_(middle), end_(end), half_width_(half_width) {
  for (int k = 0; k <= n_pieces; ++k) {
    const double t = (1 - std::cos(std::numbers::pi * k / n_pieces)) / 2;
    nodes_.push_back(t * half_width);
    values_.push_back(end + (middle - end) * f(t));
  }
}

double FallingPressure::pressure(double x) const {
  return end_ + (middle_ - end_) * f_(std::abs(x) / half_width_);
}

double FallingPressure::line_load() const {
  double sum = 0;
  for (std::size_t k = 1; k < nodes_.size(); ++k) {
    sum += (nodes_[k] - nodes_[k - 1]) * (values_[k] + values_[k - 1]);
  }
  return sum;
}

double FallingPressure::second_moment() const {
  double sum = 0;
  for (std::size_t k = 1; k < nodes_.size(); ++k) {
    const double middle = (nodes_[k - 1] + nodes_[k]) / 2;  // Simpson's rule is exact for x² p
    sum +=
        (nodes_[k] - nodes_[k - 1]) / 3 *
        (std::pow(nodes_[k - 1], 2) * values_[k - 1] +
         2 * middle * middle * (values_[k - 1] + values_[k]) + std::pow(nodes_[k], 2) * values_[k]);
  }
  return sum / line_load();
}

double FallingPressure::displacement(const elasticity::Material& material, double x,
                                     double datum) const {
  double sum = values_.back() *
               normal_displacement(material, elasticity::UniformLoad(1, half_width_), x, datum);
  // A triangle of height w on |x| ≤ b adds −w/b to the slope on [0, b]. From the outermost piece
  // inwards, each triangle adds the slope still missing.
  double slope_so_far = 0;
  for (std::size_t k = nodes_.size() - 1; k > 0; --k) {
    const double slope = (values_[k] - values_[k - 1]) / (nodes_[k] - nodes_[k - 1]);
    const double height = (slope_so_far - slope) * nodes_[k];
    slope_so_far = slope;
    if (height == 0) continue;
    sum +=
        height * normal_displacement(material, elasticity::TriangularLoad(1, nodes_[k]), x, datum);
  }
  return sum;
}

double FallingPressure::work(const std::function<double(double)>& u) const {
  // Simpson's rule on each piece; both sides of the strip do the same work.
  double sum = 0;
  for (std::size_t k = 1; k < nodes_.size(); ++k) {
    const double middle = (nodes_[k - 1] + nodes_[k]) / 2;
    sum += (nodes_[k] - nodes_[k - 1]) / 6 *
           (values_[k - 1] * u(nodes_[k - 1]) + 2 * (values_[k - 1] + values_[k]) * u(middle) +
            values_[k] * u(nodes_[k]));
  }
  return sum;
}

double FallingPressure::largest_shear() const {
  std::vector<double> nodes, values;
  for (std::size_t k = nodes_.size() - 1; k > 0; --k) {
    nodes.push_back(-nodes_[k]);
    values.push_back(values_[k]);
  }
  nodes.insert(nodes.end(), nodes_.begin(), nodes_.end());
  values.insert(values.end(), values_.begin(), values_.end());
  const auto shear = [&](double x, double z) {
    return std::abs(elasticity::stress_beneath(nodes, values, x, z).xz);
  };

  // Beneath a jump at the end of the strip the shear stress tends to pressure/π. A greater one lies
  // beneath the end, at most a half-width deep.
  constexpr int n = 5;         // steps to either side
  constexpr double finer = 3;  // from one grid to the next
  double best = values_.back() / std::numbers::pi;
  double best_x = 0.75 * half_width_, best_z = 0.5 * half_width_;
  for (double step = half_width_ / (2.0 * n); step > 1e-4 * half_width_; step /= finer) {
    const double centre_x = best_x, centre_z = best_z;
    for (int i = -n; i <= n; ++i) {
      for (int j = -n; j <= n; ++j) {
        const double x = centre_x + i * step;
        const double z = centre_z + j * step;
        if (z <= 0) continue;
        const double here = shear(x, z);
        if (here <= best) continue;
        best = here;
        best_x = x;
        best_z = z;
      }
    }
  }
  return best;
}

elasticity::Load FallingPressure::load() const {
  return elasticity::distributed_load([*this](double x) { return pressure(x); },
                                      {-half_width_, 0, half_width_});
}

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

double one(double) {
  return 1;
}

}  // namespace

LoadFitting::LoadFitting(const HalfSpaceCase& h, const PrintedData& printed, Level level)
    : h_(h), level_(std::move(level)), observed_(values_of(printed.figure5.fea_z)) {
  for (std::size_t i = 1; i <= observed_.size(); ++i) {
    convergences_.push_back(convergence(printed, fmt::format("measure{}", i)));
  }
}

// Where the load's second moment lies between that of the triangle, a²/6, which gives 0, and that
// of the uniform load, a²/3, which gives 1.
double LoadFitting::share_of_uniform(const FallingPressure& pressure) const {
  return 6 * pressure.second_moment() / std::pow(h_.load.half_width(), 2) - 1;
}

// The computed displacements at the points divided by those observed.
VectorXd LoadFitting::ratios(const FallingPressure& pressure) const {
  const double load = pressure.line_load();
  const double share = share_of_uniform(pressure);
  VectorXd ratios(std::ssize(observed_));
  for (std::size_t i = 0; i < observed_.size(); ++i) {
    const double x = h_.points[i];
    ratios[static_cast<Index>(i)] =
        (pressure.displacement(h_.material, x, h_.datum) -
         load * std::lerp(level_.triangle.at_points[i], level_.uniform.at_points[i], share)) /
        observed_[i];
  }
  return ratios;
}

FittedLoad LoadFitting::finished(const FallingPressure& pressure) const {
  const VectorXd residuals = ratios(pressure).array() - 1;
  const Eigen::Map<const VectorXd> convergences(convergences_.data(), residuals.size());
  return {.pressure = pressure,
          .numbers = {},
          .covariance = {},
          .peak = number_with(0, 0),
          .half_width = number_with(pressure.half_width(), 0),
          .residuals = residuals,
          .shares = residuals.cwiseQuotient(convergences)};
}

FittedLoad LoadFitting::unfitted(const FallingPressure& pressure) const {
  return finished(pressure);
}

FittedLoad LoadFitting::fit(const Shape& shape, bool alone, double half_width, Width width) const {
  const Eigen::Map<const VectorXd> convergences(convergences_.data(), std::ssize(convergences_));
  const auto columns = [&](double a) {
    MatrixXd m(convergences.size(), alone ? 1 : 2);
    if (!alone) m.col(0) = ratios({one, 1, 1, a});
    m.rightCols(1) = ratios({shape.f, 1, 0, a});
    return m;
  };
  const VectorXd ones = VectorXd::Ones(convergences.size());
  const auto solve = [&](const MatrixXd& m) -> VectorXd {
    return numerics::fit(m, ones, convergences).coefficients;
  };

  double a = half_width;
  MatrixXd design = columns(a);
  VectorXd numbers = solve(design);
  if (width == Width::fitted) {
    constexpr int most_rounds = 50;
    const auto with_width = [&](double step) {  // of the half-width, for its derivative
      MatrixXd m(convergences.size(), design.cols() + 1);
      const VectorXd derivative =
          (columns(a * (1 + step)) - columns(a * (1 - step))) * numbers / (2 * step * a);
      m << design, derivative;
      return m;
    };
    for (int round = 0; round < most_rounds; ++round) {
      const double change = solve(with_width(1e-4)).tail(1)[0];
      a += std::clamp(change, -a / 10, a / 10);
      design = columns(a);
      numbers = solve(design);
      if (std::abs(change) < 1e-9 * a) break;
    }
    // Beside the end of the load the derivative is logarithmic, so the covariance uses a difference
    // over a step of about the uncertainty.
    design = with_width(1e-2);
  }

  const double end = alone ? 0 : numbers[0];
  FittedLoad fitted = finished({shape.f, numbers.sum(), end, a});
  fitted.covariance = numerics::fit(design, ones, convergences).covariance;
  VectorXd of_peak = VectorXd::Ones(design.cols());
  fitted.numbers = numbers;
  if (width == Width::fitted) {
    of_peak.tail(1).setZero();
    fitted.numbers.conservativeResize(design.cols());
    fitted.numbers.tail(1)[0] = a;
    fitted.half_width =
        number_with(a, std::sqrt(fitted.covariance.bottomRightCorner<1, 1>()(0, 0)));
  }
  fitted.peak = number_with(numbers.sum(), std::sqrt(of_peak.dot(fitted.covariance * of_peak)));
  return fitted;
}

double LoadFitting::energy(const FallingPressure& pressure) const {
  const double share = share_of_uniform(pressure);
  const auto level = [&](double LevelUnder::*where) {
    return pressure.line_load() * std::lerp(level_.triangle.*where, level_.uniform.*where, share);
  };
  const double middle = level(&LevelUnder::in_the_middle);
  const double rise = level(&LevelUnder::at_the_end) - middle;
  const double a = h_.load.half_width();
  return pressure.work([&](double x) {
    return pressure.displacement(h_.material, x, h_.datum) - middle - rise * std::pow(x / a, 2);
  });
}

}  // namespace paper
