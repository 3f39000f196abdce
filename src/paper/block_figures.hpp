// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "literate/document/document.hpp"
#include "paper/block_study.hpp"
#include "parameters/case.hpp"

namespace paper {

/// The deformed block with contours of u_z (Fig. 3), its mesh, the convergence of its measures, and
/// for printed data the misfit over the edge fraction and the curves like with like.
void register_block_figures(literate::Document& document,
                            const parameters::HalfSpaceCase& half_space,
                            const parameters::BlockCase& block_case,
                            const config::UnitSystem& units, const BlockStudy& study);

}  // namespace paper
