// SPDX-License-Identifier: GPL-3.0-or-later
// Which pressure explains the printed displacements: shapes with two free numbers each, a uniform
// part and one that falls to zero at the ends of the load.
#pragma once

#include <string>
#include <vector>

#include "block/fit.hpp"
#include "block/supports.hpp"
#include "paper/block_study.hpp"
#include "paper/prelude.hpp"

namespace paper {

/// One shape on some supports, fitted to the printed displacements.
struct Contestant {
  std::string shape;
  int n_free;  ///< numbers that were fitted, 1 or 2
  /// Whether what falls does so about half-way: its share at t = |x|/a is 1 less that at 1 − t.
  bool falls_about_half;
  block::Supports supports;
  Estimate largest_misfit;  ///< relative; wrong by its distance from the coarser mesh
  Measured peak;  ///< the largest pressure, in the middle or at the ends of the load
  block::RefinedSolution refitted;  ///< under the fits made on each of the two meshes
};

/// All shapes on the supports of the case, each alone or on a uniform pressure, then the linear
/// fall on other supports.
std::vector<Contestant> contest(const BlockStudy& study, const HalfSpaceCase& half_space,
                                block::Support sides);

/// p = p_e + (p_0 − p_e)(1 − |x/a|ᵐ) with the exponent m fitted besides p_0 and p_e.
///
/// `best` makes the sum of squares least, of residuals over their uncertainties. With each m from
/// `least` to `most` a choice of p_0 and p_e meets every displacement to `allowed`; both are `best`
/// if not even that does. Each number is wrong by its distance from the coarser mesh.
struct ExponentFit {
  Estimate best, least, most;
  Estimate misfit;                         ///< the largest at `best`, relative
  std::vector<double> exponents, misfits;  ///< the largest misfit for each of many exponents
};

/// The exponents that are tried.
constexpr double least_exponent = 0.3;
constexpr double most_exponent = 4;

/// Fits the exponent on the block with these sides. The displacements under 1 − |x/a|ᵐ are smooth
/// in m: they are computed for some m and interpolated by a polynomial. Throws as
/// SupportedBlock::solve does.
ExponentFit fit_exponent(const BlockStudy& study, double half_width, block::Support sides,
                         double allowed);

/// The largest relative misfit of a load as it is, without any fit.
Estimate misfit_of(const BlockStudy& study, const elasticity::Load& load, block::Support sides);

}  // namespace paper
