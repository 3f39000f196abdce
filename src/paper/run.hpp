// SPDX-License-Identifier: GPL-3.0-or-later
// The finite-element run of the paper's Appendix 2: what its summary says of the body, and which
// load it carried.
#pragma once

#include <string>
#include <vector>

#include "paper/block_study.hpp"
#include "paper/falling_pressure.hpp"
#include "paper/paper.hpp"

namespace paper {

/// The datum at which a half-space would be displaced as much as the block whose level this is.
Estimate equivalent_datum(const HalfSpaceCase& h, Estimate level);

/// Registers what the summary says of the body and of its stresses, and what the difference
/// of the printed columns is made of.
void describe_run(Document& document, const Case& from, const BlockStudy& study);

/// Registers which load the run carried, and returns the inferred load: the linear fall that meets
/// its displacements best. `levels` are those of the block on the supports assumed, and on others.
FallingPressure infer_load(Document& document, const Case& from, const BlockStudy& study,
                           const std::vector<Level>& levels);

}  // namespace paper
