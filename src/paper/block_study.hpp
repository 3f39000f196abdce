// SPDX-License-Identifier: GPL-3.0-or-later
// The finite block of the paper's Appendix 2, and the run that the paper prints.
#pragma once

#include <string>
#include <vector>

#include "block/analysis.hpp"
#include "block/rectangle.hpp"
#include "paper/paper.hpp"

namespace paper {

/// The level: the displacement of a half-space's surface minus that of the block on some supports,
/// per unit of the load's resultant.
struct LevelUnder {
  double in_the_middle, at_the_end;  ///< of the case's loaded strip
  std::vector<double> at_points;     ///< at the case's points
};

/// The level under a triangle on the strip and under a uniform pressure on it.
///
/// Between these two loads the level varies with the second moment of the load, which is twice as
/// large for the uniform pressure; higher moments matter only by powers of (strip/block)⁴.
struct Level {
  std::string supports;
  LevelUnder triangle, uniform;
};

/// The finite block of a case, by finite elements on a mesh for its load.
class BlockStudy {
 public:
  /// Throws what block::Analysis throws.
  BlockStudy(const HalfSpaceCase& half_space, const BlockCase& block_case);

  /// The block on the case's supports.
  const block::SupportedBlock& own() const { return own_; }

  /// The same block under eq. (4), the load that the paper states.
  const block::RefinedSolution& under_triangle() const { return under_triangle_; }

  /// The block on other supports, factorised again.
  block::SupportedBlock on(const block::Supports& supports) const { return analysis_.on(supports); }

  /// The level of a supported block under any load on roughly the strip of the case.
  Level level(const std::string& name, const block::SupportedBlock& supported) const;

  /// The solution under eq. (4) of a block `factor` times as wide and high.
  block::RefinedSolution enlarged(double factor) const;

  /// u_z by eq. (3) minus that of the block under the triangle, at x on the surface; a length.
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

/// The datum with which a half-space is displaced as much as the block of this level.
Estimate equivalent_datum(const HalfSpaceCase& h, Estimate level);

/// Registers the properties of the body and its stresses from the run's summary, and the
/// contributions to the difference of the printed columns.
void describe_run(Document& document, const Case& from, const BlockStudy& study);

}  // namespace paper
