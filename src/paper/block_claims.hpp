// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "block/analysis.hpp"
#include "block/rectangle.hpp"
#include "paper/block_study.hpp"
#include "paper/load_contest.hpp"
#include "paper/prelude.hpp"
#include "paper/printed_data.hpp"

namespace paper {

/// The paper's difference, analytical − FEA, taken apart; every part a length, the sum the whole.
struct Share {
  double x, whole, datum, body, load, rest;
};

/// The parts at each point on two meshes: a part is that of the finer, and wrong by the distance
/// from the coarser and by what the half-space's closed form may be wrong.
class SharesOnBothMeshes {
 public:
  SharesOnBothMeshes(std::vector<Share> fine, std::vector<Share> coarse, double of_half_space)
      : fine_(std::move(fine)), coarse_(std::move(coarse)), of_half_space_(of_half_space) {}

  std::size_t size() const { return fine_.size(); }
  double x(std::size_t i) const { return fine_[i].x; }
  const std::vector<Share>& fine() const { return fine_; }

  Estimate part(double Share::*which, std::size_t i) const {
    return {fine_[i].*which, std::abs(fine_[i].*which - coarse_[i].*which) + of_half_space_};
  }

 private:
  std::vector<Share> fine_, coarse_;
  double of_half_space_;
};

/// What the paper says of its body, of its run and of the comparison, tried on the block. `fitted`
/// are the measures under the fitted load.
void claim_block(Document& document, const HalfSpaceCase& half_space, const BlockCase& block_case,
                 const UnitSystem& units, const PrintedData& printed_data, const BlockStudy& study,
                 const std::vector<block::MeasureEstimate>& fitted,
                 const SharesOnBothMeshes& shares);

/// The deformed block with contours of u_z, or for printed data the displacements of half-space and
/// block beside the printed ones.
void register_block_figures(Document& document, const HalfSpaceCase& half_space,
                            const BlockCase& block_case, const UnitSystem& units,
                            const BlockStudy& study, const std::optional<PrintedData>& printed);

/// Which load the finite-element run carried, as far as what it prints tells: a linear fall fitted
/// to its displacements, then held to its resultant and weighed with its largest stress; the same
/// fall with round numbers and nothing fitted; other shapes and other supports.
void infer_load(Document& document, const HalfSpaceCase& half_space, block::Support sides,
                const UnitSystem& units, const PrintedData& printed_data, const BlockStudy& study);

/// The largest shear stress, which is inside the body, under each load that meets the
/// displacements.
void claim_shear(Document& document, const BlockStudy& study, const PrintedData& printed_data,
                 const UnitSystem& units, const std::vector<const Contestant*>& meets);


}  // namespace paper
