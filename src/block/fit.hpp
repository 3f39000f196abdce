// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "block/analysis.hpp"
#include "elasticity/load.hpp"
#include "numerics/estimate.hpp"

namespace block {

/// A displacement to be explained: u_z > 0 (into the body) at x on the top.
struct SurfaceDisplacement {
  double x;
  double u_z;
};

/// How well a sum of loads explains displacements, and what it predicts.
struct Fit {
  std::vector<numerics::Estimate> factors;  ///< of the loads, in their order
  std::vector<double> residuals;  ///< relative, computed/observed − 1, one an observation
  double max_misfit;              ///< the largest |residual|
  double rms_misfit;              ///< √(mean residual²)
  RefinedSolution solution;       ///< the block under the fitted load
};

/// The factors c_k that minimise Σᵢ [(Σ_k c_k u_k(xᵢ) − uᵢ)/uᵢ]², u_k the displacement under load
/// k.
///
/// The displacement is linear in the load, so this is linear least squares, solved by a Householder
/// QR. Errors of the factors are those of discretisation: the distance from the same fit on the
/// coarser mesh. One load gives the best scale of a one-parameter family. `solutions` are of one
/// SupportedBlock, one a load. Throws InvalidQuantity for fewer observations than loads, no load,
/// an observed displacement not > 0 and a point off the block.
Fit fit_loads(const std::vector<RefinedSolution>& solutions,
              const std::vector<SurfaceDisplacement>& observed);

/// The linear fall (see linear_fall) that explains displacements best.
struct LinearFit {
  numerics::Estimate peak;           ///< stress
  numerics::Estimate edge_fraction;  ///< of the peak, at |x| = half_width
  elasticity::Load load;             ///< both put into a load
  Fit fit;
};

/// Fits peak and edge fraction freely. p = peak·(1 − |x|/a) + (peak·edge_fraction)·|x|/a is linear
/// in {peak, peak·edge_fraction}, so that fit_loads with these two loads is exact. The mesh must
/// have been made for a load with kinks at 0 and ±half_width for the errors to be small.
LinearFit fit_linear_load(const SupportedBlock& block, double half_width,
                          const std::vector<SurfaceDisplacement>& observed);

}  // namespace block
