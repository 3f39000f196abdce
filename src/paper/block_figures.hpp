// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "paper/block_study.hpp"
#include "paper/prelude.hpp"
#include "paper/printed_data.hpp"

namespace paper {

/// The deformed block with contours of u_z (Fig. 3), its mesh, the convergence of its measures, and
/// for printed data the displacements of half-space and block beside the printed ones.
void register_block_figures(Document& document, const HalfSpaceCase& half_space,
                            const BlockCase& block_case, const UnitSystem& units,
                            const BlockStudy& study, const std::optional<PrintedData>& printed);

}  // namespace paper
