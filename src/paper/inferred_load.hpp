// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "block/rectangle.hpp"
#include "paper/block_study.hpp"
#include "paper/prelude.hpp"
#include "paper/printed_data.hpp"

namespace paper {

/// Which load the finite-element run carried, as far as what it prints tells: a linear fall fitted
/// to its displacements, then held to its resultant and weighed with its largest stress; the same
/// fall with round numbers and nothing fitted; other shapes and other supports.
void infer_load(Document& document, const HalfSpaceCase& half_space, block::Support sides,
                const UnitSystem& units, const PrintedData& printed_data, const BlockStudy& study);

}  // namespace paper
