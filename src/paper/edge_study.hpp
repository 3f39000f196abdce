// SPDX-License-Identifier: GPL-3.0-or-later
// What a grid that ends on the edge of the contact gains, step by step.
#pragma once

#include <vector>

#include "paper/prelude.hpp"

namespace paper {

/// The largest errors of the nodal pressures against Hertz, over p₀, on grids of so many elements
/// over the half-width, and how wrong these errors may be.
struct EdgeErrors {
  std::vector<double> elements, largest, bounds;
};

/// The pressures of unequal triangles between the case's cylinders at the given nodes, x rising,
/// with no pressure at the two outermost: eq. (1a) at the others, Σ V_ij p_j + δ = h_i, and
/// equilibrium. Accuracy: rounding of the dense system, 1e-9 of p₀ for 200 nodes.
std::vector<double> pressures_on_nodes(const ContactCase& c, const std::vector<double>& nodes);

/// Registers the table, the values and the claim about grids that end on the edge.
void study_edge(Document& document, const ContactCase& c, const Hertz& hertz);

}  // namespace paper
