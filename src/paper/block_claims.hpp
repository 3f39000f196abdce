// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "block/analysis.hpp"
#include "literate/document/document.hpp"
#include "paper/block_study.hpp"
#include "paper/printed_data.hpp"
#include "parameters/case.hpp"

namespace paper {

/// The paper's difference, analytical − FEA, taken apart; every part a length, the sum the whole.
struct Share {
  double x, whole, datum, body, load, rest;
};

/// What the paper says of its body, of its run and of the comparison, tried on the block. `fitted`
/// are the measures under the fitted load.
void claim_block(literate::Document& document, const parameters::HalfSpaceCase& half_space,
                 const parameters::BlockCase& block_case, const config::UnitSystem& units,
                 const PrintedData& printed_data, const BlockStudy& study,
                 const std::vector<block::MeasureEstimate>& fitted,
                 const std::vector<Share>& shares);

}  // namespace paper
