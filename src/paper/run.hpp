// SPDX-License-Identifier: GPL-3.0-or-later
// The finite-element run of the paper's Appendix 2: its body and the load that it carried.
#pragma once

#include <string>
#include <vector>

#include "paper/block_study.hpp"
#include "paper/falling_pressure.hpp"
#include "paper/paper.hpp"

namespace paper {

/// The datum with which a half-space is displaced as much as the block of this level.
Estimate equivalent_datum(const HalfSpaceCase& h, Estimate level);

/// Registers the properties of the body and its stresses from the run's summary, and the
/// contributions to the difference of the printed columns.
void describe_run(Document& document, const Case& from, const BlockStudy& study);

/// Registers the load that the run carried and returns it: the linear fall that best matches the
/// displacements. `levels` are those of the block on the assumed supports, first, and on others.
FallingPressure infer_load(Document& document, const Case& from, const BlockStudy& study,
                           const std::vector<Level>& levels);

}  // namespace paper
