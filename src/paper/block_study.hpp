// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "block/analysis.hpp"
#include "block/fit.hpp"
#include "block/rectangle.hpp"
#include "paper/prelude.hpp"
#include "paper/printed_data.hpp"

namespace paper {

/// The finite block of the paper, on all supports and under all loads that the report speaks of.
///
/// One mesh serves all loads, one factorisation all loads on the same supports. The three kinds of
/// sides are factorised side by side.
class BlockStudy {
 public:
  /// `observed` are the printed displacements, none without printed data. Throws as
  /// block::Analysis.
  BlockStudy(const HalfSpaceCase& half_space, const BlockCase& block_case,
             std::vector<block::SurfaceDisplacement> observed);

  /// The block with these sides on a clamped bottom.
  const block::SupportedBlock& on(block::Support sides) const {
    return *sides_[static_cast<std::size_t>(sides)];
  }

  /// The block on any supports, factorised anew.
  block::SupportedBlock on(const block::Supports& supports) const { return analysis_.on(supports); }

  /// A block of `factor` times the width and height with these sides on a clamped bottom, meshed
  /// for the same load.
  block::SupportedBlock enlarged(double factor, block::Support sides) const;

  /// The block with the case's sides under eq. (4), the load that the paper states.
  const block::RefinedSolution& under_triangle() const { return *under_triangle_; }

  /// The printed displacements as the fit wants them; empty without printed data.
  const std::vector<block::SurfaceDisplacement>& observed() const { return observed_; }

  /// The linear fall that explains the printed displacements best, on the case's sides, and on any.
  const std::optional<block::LinearFit>& fit() const { return fit_; }
  block::LinearFit fit_on(block::Support sides) const;

  /// The block under the fit made on each of the two meshes, so that errors are those of the fit as
  /// well; fit().fit.solution has the finer mesh's factors on both. Only if there is a fit.
  const block::RefinedSolution& under_fit() const { return *under_fit_; }

  /// How far a misfit of the fit moves at most when fitted on the coarser mesh.
  double misfit_error() const { return misfit_error_; }

  /// Where the measures of Appendix 2 are taken: the case's points, off the singular points.
  block::MeasureOptions measure_options() const;

 private:
  HalfSpaceCase half_space_;
  BlockCase block_case_;
  block::Analysis analysis_;
  std::array<std::optional<block::SupportedBlock>, 3> sides_;  // as block::Support counts them
  std::optional<block::RefinedSolution> under_triangle_;
  std::vector<block::SurfaceDisplacement> observed_;
  std::optional<block::LinearFit> fit_;
  std::optional<block::RefinedSolution> under_fit_;
  double misfit_error_ = 0;
};

/// The printed z-displacements of Fig. 5 at the points of the half-space, the convergence that
/// Appendix 2 prints of each taken as its standard uncertainty. Throws for points of which it
/// prints none.
std::vector<block::SurfaceDisplacement> observed_in(const HalfSpaceCase& half_space,
                                                    const PrintedData& printed);

/// Mass, centre and moments of inertia of the case's block, named and ordered as in the printed
/// summary; in the units of the case, for unit thickness.
std::vector<std::pair<std::string, double>> mass_by_name(const BlockCase& block_case);

/// "clamped", "roller" or "free".
std::string name_of(block::Support sides);

}  // namespace paper
