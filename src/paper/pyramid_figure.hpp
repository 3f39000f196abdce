// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "literate/document/document.hpp"

namespace paper {

/// The pyramid and a neighbour over the lattice, in units of the spacing, a line a row of two
/// points; and the displacements of elements of load 1 at a distance.
literate::Figure pyramid_figure();

}  // namespace paper
