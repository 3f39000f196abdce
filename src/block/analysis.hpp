// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "block/discretization.hpp"
#include "block/factorization.hpp"
#include "block/measures.hpp"
#include "block/rectangle.hpp"
#include "numerics/estimate.hpp"

namespace block {

/// A measure with its discretisation error.
struct MeasureEstimate {
  std::string name;
  numerics::Estimate value;
};

/// One load's solution on two discretisations. Every value is that of the finer, its abs_error the
/// distance from the coarser: pessimistic by orders where p-convergence is exponential, as it is
/// for displacements and energy, and no bound for max_stress_prin (see measures). For a measure the
/// distance from the maximum over every second point of the plotting grid comes besides, an
/// estimate of what the spacing of the grid costs, an error of second order: too small where the
/// greatest value lies as near to a point of the one grid as of the other.
class RefinedSolution {
 public:
  RefinedSolution(Solution fine, Solution coarse);

  /// Σ factor_k·solution_k on both discretisations; see Solution::combination.
  static RefinedSolution combination(const std::vector<RefinedSolution>& solutions,
                                     const std::vector<double>& factors);

  const Solution& fine() const { return fine_; }
  const Solution& coarse() const { return coarse_; }

  /// u_z at any point, a length; InvalidQuantity is thrown outside the block.
  numerics::Estimate displacement_z(double x, double z) const;

  /// The measures of Appendix 2, see measures().
  std::vector<MeasureEstimate> measures(const MeasureOptions& options) const;

 private:
  Solution fine_;
  Solution coarse_;
};

/// A block on given supports, factorised on both discretisations for any number of loads.
class SupportedBlock {
 public:
  SupportedBlock(std::shared_ptr<const Model> fine, std::shared_ptr<const Model> coarse,
                 const Supports& supports);

  const Factorization& fine() const { return fine_; }
  const Factorization& coarse() const { return coarse_; }

  /// Throws as Factorization::solve does.
  RefinedSolution solve(const elasticity::Load& load) const;

 private:
  Factorization fine_;
  Factorization coarse_;
};

/// The finite block of Appendix 2 in plane strain, from its dimensions to estimates with errors.
///
///   const Analysis analysis({2, 1}, material, {load}, {.order = 8, .refine = 1});
///   const SupportedBlock clamped = analysis.on(with_sides(Support::clamped));
///   const numerics::Estimate u_z = clamped.solve(load).displacement_z(0.05, 0);
class Analysis {
 public:
  /// Meshes the block for the loads (see graded_mesh) at the discretisation and at coarser() of it,
  /// and computes the element stiffnesses. Throws InvalidQuantity for any input out of range, and
  /// for a mesh too large, before memory is taken.
  Analysis(const Rectangle& block, const elasticity::Material& material,
           const std::vector<elasticity::Load>& loads, const Discretization& discretization = {});

  const std::shared_ptr<const Model>& fine() const { return fine_; }
  const std::shared_ptr<const Model>& coarse() const { return coarse_; }

  /// The block on the given supports; see Factorization for what is thrown.
  SupportedBlock on(const Supports& supports) const;

 private:
  std::shared_ptr<const Model> fine_;
  std::shared_ptr<const Model> coarse_;
};

}  // namespace block
