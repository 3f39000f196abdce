// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "block/analysis.hpp"
#include "elasticity/load.hpp"
#include "numerics/measured.hpp"

namespace block {

/// A displacement to be explained: u_z > 0 (into the body) at x on the top, with what is known of
/// its uncertainty.
struct SurfaceDisplacement {
  double x;
  numerics::Measured u_z;
};

/// How well a sum of loads explains displacements, and what it predicts.
struct Fit {
  /// Of the loads, in their order: with the standard uncertainties that those of the displacements
  /// leave them, and bounds on their errors of discretisation.
  std::vector<numerics::Measured> factors;
  std::vector<double> residuals;  ///< relative, computed/observed − 1, one an observation
  double max_misfit = 0;          ///< the largest |residual|
  RefinedSolution solution;       ///< the block under the fitted load
};

/// The observed displacements over themselves: ones, with their relative uncertainties sᵢ.
std::vector<numerics::Measured> relative(const std::vector<SurfaceDisplacement>& observed);

/// The factors c_k that minimise Σᵢ [(Σ_k c_k u_k(xᵢ) − uᵢ)/(sᵢuᵢ)]², u_k the displacement under
/// load k and sᵢ the relative standard uncertainty of the displacement uᵢ; all sᵢ are 1 if none has
/// one.
///
/// The displacement is linear in the load, so this is linear least squares (numerics::fit_linear).
/// The bound on the error of a factor is that of discretisation: the distance from the same fit on
/// the coarser mesh. One load gives the best scale of a one-parameter family. `solutions` are of
/// one SupportedBlock, one a load. Throws InvalidQuantity for fewer observations than loads, no
/// load, an observed displacement not > 0, a point off the block, and for what fit_linear refuses.
Fit fit_loads(const std::vector<RefinedSolution>& solutions,
              const std::vector<SurfaceDisplacement>& observed);

/// The same on the coarser mesh alone, to see how far it moves.
Fit fit_coarse_loads(const std::vector<RefinedSolution>& solutions,
                     const std::vector<SurfaceDisplacement>& observed);

/// The linear fall (see linear_fall) that explains displacements best.
struct LinearFit {
  numerics::Measured peak;           ///< stress
  numerics::Measured edge;           ///< stress at |x| = half_width
  numerics::Measured edge_fraction;  ///< edge over peak
  elasticity::Load load;             ///< both put into a load
  Fit fit;
};

/// Fits peak and edge fraction freely. p = peak·(1 − |x|/a) + (peak·edge_fraction)·|x|/a is linear
/// in {peak, peak·edge_fraction}, so that fit_loads with these two loads is exact. The mesh must
/// have been made for a load with kinks at 0 and ±half_width for the errors to be small.
LinearFit fit_linear_load(const SupportedBlock& block, double half_width,
                          const std::vector<SurfaceDisplacement>& observed);

}  // namespace block
