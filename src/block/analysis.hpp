// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "block/factorization.hpp"
#include "block/mesh.hpp"
#include "block/rectangle.hpp"
#include "numerics/estimate.hpp"

namespace block {

/// A measure with its discretisation error.
struct MeasureEstimate {
  std::string name;
  numerics::Estimate value;
};

/// A value on each of three discretisations: the requested one, and those one and two levels
/// coarser().
template <class T>
using Levels = std::array<T, 3>;

/// One load's solution on three discretisations. Every value is that of the finest; its abs_error
/// is the distance to the second plus half the distance from the second to the third. This bound
/// held in more than ten thousand comparisons with finer meshes. It is pessimistic by orders of
/// magnitude where convergence is exponential, as it is for displacements and energy.
class RefinedSolution {
 public:
  /// `left_out`: the discs that the stress measures exclude; see discs_without_limit.
  RefinedSolution(Levels<Solution> levels, std::vector<Disc> left_out);

  const Solution& fine() const { return levels_[0]; }

  /// u_z at any point, a length. Throws InvalidQuantity outside the block.
  numerics::Estimate displacement_z(double x, double z) const;

  /// The measures of Appendix 2, see block::measures.
  std::vector<MeasureEstimate> measures(const std::vector<double>& surface_points = {}) const;

  /// The discs that the stress measures exclude, because stress has no limit there.
  const std::vector<Disc>& left_out() const { return left_out_; }

 private:
  Levels<Solution> levels_;
  std::vector<Disc> left_out_;
};

/// A block on given supports, factorised on three discretisations for any number of loads.
class SupportedBlock {
 public:
  SupportedBlock(const Rectangle& block, const Levels<std::shared_ptr<const Model>>& models,
                 const Supports& supports);

  const Factorization& fine() const { return levels_[0]; }

  /// Throws what Factorization::solve throws.
  RefinedSolution solve(const elasticity::Load& load) const;

 private:
  Rectangle block_;
  Supports supports_;
  Levels<Factorization> levels_;
};

/// The finite block of Appendix 2 in plane strain, from dimensions to estimates with errors.
///
///   const Analysis analysis({2, 1}, material, {load}, {.order = 8, .refine = 1});
///   const SupportedBlock clamped = analysis.on(with_sides(Support::clamped));
///   const numerics::Estimate u_z = clamped.solve(load).displacement_z(0.05, 0);
class Analysis {
 public:
  /// Meshes the block for the loads (see graded_mesh) and computes the element stiffnesses. Throws
  /// InvalidQuantity for any input out of range.
  Analysis(const Rectangle& block, const elasticity::Material& material,
           const std::vector<elasticity::Load>& loads, const Discretization& discretization = {});

  const std::shared_ptr<const Model>& fine() const { return levels_[0]; }

  /// The block on the given supports. Throws what Factorization throws.
  SupportedBlock on(const Supports& supports) const { return {block_, levels_, supports}; }

 private:
  Rectangle block_;
  Levels<std::shared_ptr<const Model>> levels_;
};

}  // namespace block
