// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "block/analysis.hpp"
#include "block/rectangle.hpp"
#include "paper/prelude.hpp"

namespace paper {

/// How much less than a half-space's the surface of a block on some supports is displaced, per unit
/// of the load's resultant.
struct LevelUnder {
  double in_the_middle, at_the_end;  ///< of the strip of the case
  std::vector<double> at_points;     ///< of the case
};

/// The same under a triangle on the strip and under a uniform pressure on it.
///
/// Between these two loads the level changes with the second moment of the load, which is twice as
/// large for the uniform one, and with higher moments only by powers of (strip/block)⁴.
struct Level {
  std::string supports;
  LevelUnder triangle, uniform;
};

/// The finite block of a case, by finite elements on a mesh for its load.
class BlockStudy {
 public:
  /// Throws as block::Analysis.
  BlockStudy(const HalfSpaceCase& half_space, const BlockCase& block_case);

  /// The block as the case holds it.
  const block::SupportedBlock& own() const { return own_; }

  /// The same under eq. (4), the load that the paper states.
  const block::RefinedSolution& under_triangle() const { return under_triangle_; }

  /// The block on any supports, factorised anew.
  block::SupportedBlock on(const block::Supports& supports) const { return analysis_.on(supports); }

  /// The level of the block on some supports under any load on about the strip of the case.
  Level level(const std::string& name, const block::SupportedBlock& supported) const;

  /// Under that load in a block of `factor` times the width and height.
  block::RefinedSolution enlarged(double factor) const;

  /// How much less than by eq. (3) the surface at x is displaced under the triangle: a length.
  Estimate level(const block::RefinedSolution& solution, double x) const;

 private:
  HalfSpaceCase half_space_;
  BlockCase block_case_;
  block::Analysis analysis_;
  block::SupportedBlock own_;
  block::RefinedSolution under_triangle_;
};

/// "clamped", "roller" or "free".
std::string name_of(block::Support sides);

}  // namespace paper
