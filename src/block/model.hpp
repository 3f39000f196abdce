// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "block/element.hpp"
#include "block/mesh.hpp"
#include "elasticity/loads.hpp"
#include "elasticity/material.hpp"

namespace block {

/// A meshed block of one material, with element stiffnesses condensed to the element edges.
///
/// It contains everything that is independent of supports and loads, computed once. The whole block
/// is modelled, never half of it, so that all loads are treated alike and a test can check
/// symmetry. The object is immutable and shared by pointer.
class Model {
 public:
  /// Computes and condenses the stiffness of every element. Throws FactorizationError as condense.
  Model(Mesh mesh, const elasticity::Material& material);

  const Mesh& mesh() const { return mesh_; }
  const LobattoBasis& basis() const { return basis_; }
  const Lame& lame() const { return lame_; }
  const elasticity::Material& material() const { return material_; }
  const UnknownSplit& split() const { return split_; }
  const CondensedStiffness& condensed(Index element) const;

  /// The global numbers 2·node + c of an element's unknowns, in the order of its stiffness.
  std::vector<Index> unknowns(Index element) const;

  /// The nodal forces Ku for displacements u, both of size 2·n_nodes.
  ///
  /// Each element's mean translation, which causes no strain, is subtracted first: it would cost
  /// digits that the equilibrium of thin elements needs.
  Eigen::VectorXd internal_forces(const Eigen::VectorXd& displacements) const;

 private:
  Mesh mesh_;
  elasticity::Material material_;
  Lame lame_;
  LobattoBasis basis_;
  LobattoBasis::Integrals integrals_;
  StackedIntegrals stacked_;
  UnknownSplit split_;
  std::vector<std::shared_ptr<const CondensedStiffness>> condensed_;  // shared by equal aspects
};

/// The consistent nodal forces ∫ N_i(x) p dx of a load on the top of the block.
///
/// Size 2·n_nodes, unknown 2·node + c for the component c (0: x, 1: z), force per unit thickness.
/// The quadrature is split at the load's kinks and the elements' corners and graded towards both
/// ends of each part by x ∝ 3t² − 2t³. Accuracy: rounding for polynomial pressures up to degree 4,
/// 1e-12 relative for a pressure that rises like a square root at an end of a piece. Throws what
/// require_inside throws.
Eigen::VectorXd surface_forces(const Mesh& mesh, const LobattoBasis& basis,
                               const elasticity::Load& load);

}  // namespace block
