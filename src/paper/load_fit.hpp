// SPDX-License-Identifier: GPL-3.0-or-later
// Fits pressures to the printed displacements of the run.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

#include "paper/falling_pressure.hpp"
#include "paper/run.hpp"

namespace paper {

/// The shape of a pressure: a function of t = |x|/a that falls from 1 to 0.
struct Shape {
  std::string name;
  std::function<double(double)> f;
};

/// Whether the half-width is fitted as well as the pressures.
enum class Width { held, fitted };

/// A load with its misfits to the printed displacements.
struct FittedLoad {
  FallingPressure pressure;
  /// The fitted numbers with their covariance: the uniform part (unless the shape is alone), the
  /// shape's part, and the half-width if it is fitted.
  Eigen::VectorXd numbers;
  Eigen::MatrixXd covariance;
  Number peak;                ///< the pressure in the middle
  Number half_width;          ///< without uncertainty if it is held
  Eigen::VectorXd residuals;  ///< computed over printed displacement, minus 1
  Eigen::VectorXd shares;     ///< residuals divided by the printed convergence

  double largest_residual() const { return residuals.lpNorm<Eigen::Infinity>(); }
  double largest_share() const { return shares.lpNorm<Eigen::Infinity>(); }
  double chi_squared() const { return shares.squaredNorm(); }

  /// Whether it matches every displacement to within its printed convergence.
  bool meets_all() const { return largest_share() <= 1; }
};

/// Fits loads to the printed displacements by least squares, with the printed convergences as
/// standard uncertainties.
///
/// The displacement of the block is that of the half-space minus the load times the level (check
/// `level-carries-the-load`).
class LoadFitting {
 public:
  LoadFitting(const HalfSpaceCase& h, const PrintedData& printed, Level level);

  /// Fits the pressure p_u + p_s f(t), or p_s f(t) if the shape is `alone`. The half-width is
  /// fitted by the Gauss–Newton method, starting from the given one.
  FittedLoad fit(const Shape& shape, bool alone, double half_width, Width width) const;

  /// A given load with its misfits.
  FittedLoad unfitted(const FallingPressure& pressure) const;

  /// The strain energy of the block under a load, per unit thickness.
  double energy(const FallingPressure& pressure) const;

  const std::vector<double>& convergences() const { return convergences_; }

 private:
  double share_of_uniform(const FallingPressure& pressure) const;
  Eigen::VectorXd ratios(const FallingPressure& pressure) const;
  FittedLoad finished(const FallingPressure& pressure) const;

  HalfSpaceCase h_;
  Level level_;
  std::vector<double> observed_, convergences_;
};

}  // namespace paper
