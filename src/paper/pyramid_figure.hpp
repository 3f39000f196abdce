// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "paper/prelude.hpp"

namespace paper {

/// The pyramid and a neighbour over the lattice, in units of the spacing, a line a row of two
/// points; and the displacements of elements of load 1 at a distance.
Figure pyramid_figure();

}  // namespace paper
