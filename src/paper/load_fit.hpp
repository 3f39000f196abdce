// SPDX-License-Identifier: GPL-3.0-or-later
// The load that the run carried: pressures, and their fits to its printed displacements.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

#include "elasticity/loads.hpp"
#include "elasticity/material.hpp"
#include "paper/block_study.hpp"

namespace paper {

/// A symmetric pressure p(x) = end + (middle − end) f(|x|/a) on |x| ≤ a, with f(0) = 1. It is
/// linearised between nodes, which are densest in the middle and at the ends, and is therefore a
/// sum of triangles of eq. (4) with different half-widths and a uniform part.
class FallingPressure {
 public:
  /// f on [0, 1]; middle and end are stresses, half_width > 0 a length. For a curved f the
  /// resultant is accurate to 1e-4 relative.
  FallingPressure(const std::function<double(double)>& f, double middle, double end,
                  double half_width);

  double half_width() const { return half_width_; }

  /// ∫ p dx, force per unit length.
  double line_load() const;

  /// ∫ x² p dx over the resultant, a length squared.
  double second_moment() const;

  /// u_z at the surface of a half-space with u_z(datum) = 0, a length: eq. (3) for each triangle
  /// plus the closed form of the uniform part.
  double displacement(const elasticity::Material& material, double x, double datum) const;

  /// ½∫ p u dx over the loaded strip, energy per unit thickness, for a symmetric displacement u(x)
  /// of the surface.
  double work(const std::function<double(double)>& u) const;

  /// The largest |σ_xz| in a half-space, a stress, accurate to 1e-5 relative: searched on ever
  /// finer grids around the best point.
  double largest_shear() const;

  elasticity::Load load() const;

 private:
  double pressure(double x) const;

  std::function<double(double)> f_;
  double middle_, end_, half_width_;
  std::vector<double> nodes_;   // x ≥ 0, from 0 to a
  std::vector<double> values_;  // p there
};

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

/// Registers the load that the run carried and returns it: the linear fall that best matches the
/// displacements. `levels` are those of the block on the assumed supports, first, and on others.
FallingPressure infer_load(Document& document, const Case& from, const BlockStudy& study,
                           const std::vector<Level>& levels);

}  // namespace paper
