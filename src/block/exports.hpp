// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ostream>
#include <vector>

#include "block/mesh.hpp"
#include "block/rectangle.hpp"
#include "block/solution.hpp"
#include "elasticity/load.hpp"
#include "elasticity/material.hpp"
#include "numerics/unstructured_grid.hpp"

namespace block {

/// The quadratic mesh of a deck: each column and row of `mesh` cut into as many equal parts as give
/// it about the nodes it had, with lines added at `points`, so that nodes lie there. Points nearer
/// to a line than 1e-9 of the width are on it. Throws InvalidQuantity for a point off the block.
Mesh calculix_mesh(const Mesh& mesh, const std::vector<double>& points);

/// Writes a block as a deck for CalculiX (and Abaqus): plane strain in 8-node rectangles CPE8.
///
/// `quadratic` has order 2; its element centres are left out. Axes are those of Appendix 2: x along
/// the surface, y = −z up. Supports are *BOUNDARY on side nodes, tractions consistent nodal forces
/// *CLOAD per unit thickness (CalculiX gives plane-strain elements unit thickness and spreads a
/// node's force over it). The displacements of the top's nodes at `points`, in node set POINTS, go
/// to the job's .dat file. Numbers have 13 digits, as many as
/// fit the 20 characters CalculiX reads of a field. Throws InvalidQuantity for a mesh of another
/// order, a point without a node, and as Factorization for supports and load.
void write_calculix_deck(std::ostream& out, const Mesh& quadratic,
                         const elasticity::Material& material, const Supports& supports,
                         const elasticity::Load& load, const std::vector<double>& points);

/// The deck's number of the node of the top at x; throws InvalidQuantity if there is none.
Index calculix_node(const Mesh& quadratic, double x);

/// A solution at points of every element, as ParaView can show it.
///
/// Every element becomes n_cells × n_cells bilinear cells with points of their own, so that the
/// stresses keep the jumps between elements. Axes are those of Appendix 2, y = −z up. Fields:
/// `von_mises`, `displacement` (three components) and `stress` (six components in VTK's order xx,
/// yy, zz, xy, yz, xz, with yy vertical and zz out of the plane). n_cells ≤ 0 means as many as the
/// order. Throws InvalidQuantity for n_cells above 100.
numerics::UnstructuredGrid sampled_grid(const Solution& solution, int n_cells = 0);

}  // namespace block
