// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <vector>

#include "elasticity/material.hpp"
#include "system/error.hpp"

namespace block {

/// Points in [−1, 1] and the weights of a quadrature ∫ f dξ ≈ Σ wᵢ f(ξᵢ).
struct GaussRule {
  Eigen::VectorXd points;
  Eigen::VectorXd weights;
};

/// The Gauss–Legendre rule of n ≥ 1 points, exact for polynomials of degree 2n − 1.
GaussRule gauss_rule(int n);

/// Lagrange polynomials N₀ … N_p on [−1, 1] through the p + 1 Gauss–Lobatto points: ±1 and the
/// interior extremes of Legendre's polynomial P_p.
///
/// These nodes keep the basis well conditioned for every order used here, and the end nodes make
/// neighbouring elements conform. All members are accurate to about 1e-15·p².
class LobattoBasis {
 public:
  /// order p ≥ 1.
  explicit LobattoBasis(int order);

  int order() const { return static_cast<int>(nodes_.size()) - 1; }
  const Eigen::VectorXd& nodes() const { return nodes_; }

  /// N_i(ξ), i = 0 … p, by the barycentric formula.
  Eigen::VectorXd values(double xi) const;

  /// N_i(ξ_k) as a matrix of points × (p + 1), and dN_i/dξ(ξ_k) likewise; the derivatives are exact
  /// because its nodal values determine each polynomial N_i.
  Eigen::MatrixXd values_at(const Eigen::VectorXd& points) const;
  Eigen::MatrixXd derivatives_at(const Eigen::VectorXd& points) const;

  /// The integrals that make up every rectangular element, each (p + 1) × (p + 1), exact.
  struct Integrals {
    Eigen::MatrixXd mass;       ///< ∫ N_i N_j dξ
    Eigen::MatrixXd stiffness;  ///< ∫ N_i′ N_j′ dξ
    Eigen::MatrixXd slope;      ///< ∫ N_i′ N_j dξ
  };
  Integrals integrals() const;

 private:
  Eigen::VectorXd nodes_;
  Eigen::VectorXd barycentric_weights_;
  Eigen::MatrixXd nodal_derivatives_;  // dN_j/dξ at node i
};

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
