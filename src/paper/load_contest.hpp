// SPDX-License-Identifier: GPL-3.0-or-later
// Which pressure explains the printed displacements: shapes with two free numbers each, a uniform
// part and one that falls to zero at the ends of the load.
#pragma once

#include <string>
#include <vector>

#include "block/fit.hpp"
#include "block/rectangle.hpp"
#include "paper/block_study.hpp"
#include "paper/prelude.hpp"

namespace paper {

/// How far a load is from the displacements observed; wrong by its distance from the coarser mesh.
struct Misfit {
  Estimate largest;        ///< |computed/observed − 1|
  Estimate largest_share;  ///< the largest of these over its standard uncertainty, or as it is
  Estimate chi_squared;    ///< Σ of the squares of these shares
};

/// One shape on some supports, fitted to the printed displacements or as it is.
struct Contestant {
  std::string shape;
  int n_free;  ///< numbers that were fitted, 0, 1 or 2
  block::Supports supports;
  Misfit misfit;
  Measured peak;  ///< the largest pressure, in the middle or at the ends of the load
  block::RefinedSolution refitted;  ///< under the fits made on each of the two meshes
};

/// All shapes on the supports of the case, each alone or on a uniform pressure, among them a
/// triangle that is narrower than the load, then the linear fall on other supports.
std::vector<Contestant> contest(const BlockStudy& study, const HalfSpaceCase& half_space,
                                block::Support sides);

/// The load of round numbers: the stated peak in the middle falls linearly to this share of it.
constexpr double round_edge_share = 0.6;
elasticity::Load round_load(const HalfSpaceCase& half_space);

/// A load as it is, without any fit, with its largest pressure.
Contestant unfitted(const BlockStudy& study, const std::string& shape, const elasticity::Load& load,
                    double peak, block::Support sides);

}  // namespace paper
