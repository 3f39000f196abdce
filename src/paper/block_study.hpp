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
#include "block/supports.hpp"
#include "paper/printed_data.hpp"
#include "parameters/case.hpp"

namespace paper {

/// Of the top of the trapezoid: between the triangle's 0 and the uniform pressure's 1.
inline constexpr double flat_fraction = 0.6;

/// A load shape on some supports, scaled to the printed displacements as well as it can be.
struct Candidate {
  std::string shape;
  block::Support sides;
  block::Fit fit;
  double misfit_error;  ///< how far a misfit moves at most when fitted on the coarser mesh
  block::RefinedSolution refitted;  ///< under the fits made on each of the two meshes
};

/// The finite block of the paper, on all supports and under all loads that the report speaks of.
///
/// One mesh serves all loads, one factorisation all loads on the same supports. The three kinds of
/// sides are solved side by side.
class BlockStudy {
 public:
  /// `observed` are the printed displacements, none without printed data. Throws as
  /// block::Analysis.
  BlockStudy(const parameters::HalfSpaceCase& half_space, const parameters::BlockCase& block_case,
             std::vector<block::SurfaceDisplacement> observed);

  const block::SupportedBlock& on(block::Support sides) const { return all_on(sides).block; }

  /// The block under the triangle and under the uniform pressure, of which every linear fall is a
  /// sum, both of peak 1.
  const std::vector<block::RefinedSolution>& falls_on(block::Support sides) const {
    return all_on(sides).falls;
  }

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

  /// Every candidate of the report: the linear fall on each kind of side, then single shapes.
  std::vector<Candidate> candidates() const;

  /// Where the measures of Appendix 2 are taken: the case's points, off the singular points.
  block::MeasureOptions measure_options() const;

 private:
  struct OnSides {
    OnSides(const block::Analysis& analysis, block::Support sides, double half_width);

    block::SupportedBlock block;
    std::vector<block::RefinedSolution> falls;
  };
  const OnSides& all_on(block::Support sides) const {
    return *sides_[static_cast<std::size_t>(sides)];
  }

  parameters::HalfSpaceCase half_space_;
  parameters::BlockCase block_case_;
  block::Analysis analysis_;
  std::array<std::optional<OnSides>, 3> sides_;  // as block::Support counts them
  std::optional<block::RefinedSolution> under_triangle_;
  std::vector<block::SurfaceDisplacement> observed_;
  std::optional<block::LinearFit> fit_;
  std::optional<block::RefinedSolution> under_fit_;
  double misfit_error_ = 0;
};

/// The printed z-displacements of Fig. 5 at the points of the half-space.
std::vector<block::SurfaceDisplacement> observed_in(const parameters::HalfSpaceCase& half_space,
                                                    const PrintedFigure5& printed);

/// Mass, centre and moments of inertia of the case's block, named and ordered as in the printed
/// summary; in the units of the case, for unit thickness.
std::vector<std::pair<std::string, double>> mass_by_name(const parameters::BlockCase& block_case);

/// "clamped", "roller" or "free".
std::string name_of(block::Support sides);

}  // namespace paper
