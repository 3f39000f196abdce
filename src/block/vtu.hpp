// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ostream>

#include "block/solution.hpp"

namespace block {

/// Writes a solution as a VTU file (VTK's XML unstructured grid, ASCII) for ParaView.
///
/// Every element becomes n_cells × n_cells bilinear cells with points of their own, so that the
/// stresses keep the jumps between elements. Axes are those of Appendix 2, y = −z up. Point data:
/// `displacement` (three components), `stress` (six components in VTK's order xx, yy, zz, xy, yz,
/// xz, with yy vertical and zz out of the plane) and `von_mises`; nine digits. n_cells ≤ 0 means as
/// many as the order. Throws InvalidQuantity for n_cells above 100.
void write_vtu(std::ostream& out, const Solution& solution, int n_cells = 0);

}  // namespace block
