// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <vector>

#include "block/lobatto_basis.hpp"
#include "elasticity/material.hpp"
#include "system/error.hpp"

namespace block {

/// A stiffness matrix whose factorisation or solution failed; what() names it and the reason.
class FactorizationError : public sys::ComputationError {
 public:
  using ComputationError::ComputationError;
};

/// Lamé's constants λ = Eν/[(1 + ν)(1 − 2ν)] and μ = E/[2(1 + ν)], two stresses.
struct Lame {
  double lambda;
  double mu;
};
Lame lame(const elasticity::Material& material);

/// The stiffness ∫ Bᵀ D B dx dz of a rectangle in plane strain, unit thickness; a stress.
///
/// With strains ε_xx = ∂u_x/∂x, ε_zz = ∂u_z/∂z, γ = ∂u_x/∂z + ∂u_z/∂x and stresses by λ and μ, the
/// integrals along the two edges separate: the matrix is a sum of Kronecker products of the
/// one-dimensional `integrals`, exact for every order. It depends only on the rectangle's aspect
/// ratio, height over width. Size 2(p + 1)²; unknown 2[j(p + 1) + i] + c is component c (0: x, 1:
/// z) at the node at step i along x and j along z.
Eigen::MatrixXd element_stiffness(const LobattoBasis::Integrals& integrals, const Lame& lame,
                                  double aspect);

/// The one-dimensional integrals stacked, so that one matrix product applies all of them.
struct StackedIntegrals {
  explicit StackedIntegrals(const LobattoBasis::Integrals& integrals);
  Eigen::MatrixXd along_x;  ///< stiffness, mass, slope, slopeᵀ; 4(p + 1) × (p + 1)
  Eigen::MatrixXd along_z;  ///< mass, stiffness, slope, slopeᵀ
};

/// An element's stiffness times the displacements u of its nodes, without forming the matrix: the
/// Kronecker products act along x and z in turn. u and the returned forces are (p + 1) × 2(p + 1)
/// matrices: row i, column c(p + 1) + j is component c at the node at step i along x and j along z.
Eigen::MatrixXd element_forces(const StackedIntegrals& integrals, const Lame& lame, double aspect,
                               const Eigen::MatrixXd& u);

/// The unknowns of an element on its edges and inside it, as indices into its stiffness.
struct UnknownSplit {
  std::vector<int> edge;
  std::vector<int> interior;
};
UnknownSplit split_unknowns(int order);

/// A stiffness whose interior unknowns have been eliminated (static condensation):
/// S = K_ee − K_ei K_ii⁻¹ K_ie, u_i = K_ii⁻¹ f_i − R u_e with R = K_ii⁻¹ K_ie.
struct CondensedStiffness {
  Eigen::MatrixXd edge;                  ///< S
  Eigen::MatrixXd recovery;              ///< R
  Eigen::LLT<Eigen::MatrixXd> interior;  ///< factor of K_ii
};

/// Eliminates the interior unknowns. Throws FactorizationError if K_ii is not positive definite.
CondensedStiffness condense(const Eigen::MatrixXd& stiffness, const UnknownSplit& split);

}  // namespace block
