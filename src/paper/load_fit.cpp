// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/load_fit.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "numerics/fit.hpp"
#include "paper/conventions.hpp"

namespace paper {
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
