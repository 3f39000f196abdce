// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <memory>
#include <vector>

#include "block/element_stiffness.hpp"
#include "block/model.hpp"

namespace block {

/// Strains in the plane; γ is the engineering shear ∂u_x/∂z + ∂u_z/∂x. All others vanish.
struct Strain {
  double xx;
  double zz;
  double gamma;
};

/// Stresses in plane strain, tension positive: three in the plane x, z (z into the body), and σ_yy
/// out of it.
struct Stress {
  double xx;
  double zz;
  double xz;
  double yy;
};

/// Hooke's law in plane strain: σ_xx = λ(ε_xx + ε_zz) + 2με_xx, σ_zz alike, σ_xz = μγ and
/// σ_yy = λ(ε_xx + ε_zz) = ν(σ_xx + σ_zz).
Stress stress(const Lame& lame, const Strain& strain);

/// von Mises's √{½[(σ_xx−σ_zz)² + (σ_zz−σ_yy)² + (σ_yy−σ_xx)²] + 3σ_xz²}, a stress ≥ 0.
double von_mises(const Stress& stress);

/// The three principal stresses, the largest first; one of them is σ_yy.
std::array<double, 3> principal_stresses(const Stress& stress);

/// What the block does at one point.
struct PointState {
  Eigen::Vector2d position;      ///< x, z
  Eigen::Vector2d displacement;  ///< u_x, u_z; u_z positive into the body
  Strain strain;
  Stress stress;
};

/// Force and moment of a system of nodal forces, per unit thickness.
struct Resultant {
  Eigen::Vector2d force = Eigen::Vector2d::Zero();  ///< along x and z
  double moment = 0;  ///< about the origin, z f_x − x f_z; positive turns z towards x
};

/// The displacement of the whole block under one load, and all that follows from it.
class Solution {
 public:
  /// Three vectors of size 2·n_nodes: displacements, applied nodal forces, and the forces of the
  /// supports on the nodes they hold.
  Solution(std::shared_ptr<const Model> model, Eigen::VectorXd displacements,
           Eigen::VectorXd applied_forces, Eigen::VectorXd support_forces);

  /// Σ factor_k·solution_k, the solution under the same sum of loads. One factor a solution, one or
  /// more, all of the same model and supports: asserted.
  static Solution combination(const std::vector<Solution>& solutions,
                              const std::vector<double>& factors);

  const Model& model() const { return *model_; }

  /// u = Σ N_i u_i at any point of the block; InvalidQuantity is thrown for one outside.
  Eigen::Vector2d displacement(double x, double z) const;

  /// Displacement, strain and stress at any point of the block. Strains and stresses jump from
  /// element to element by their own discretisation error; on an edge the element on the right or
  /// below is taken. InvalidQuantity is thrown outside.
  PointState at(double x, double z) const;

  /// The states at all points (ξ_k, ξ_l) of one element, k fastest; `points` lie in [−1, 1].
  std::vector<PointState> sample(Index element, const Eigen::VectorXd& points) const;

  /// ½∫ σ·ε dx dz = ½ uᵀKu, energy per unit thickness.
  double strain_energy() const;

  /// What is applied: the load, and body forces if any.
  Resultant applied() const;

  /// What the supports do to the block: Ku − f summed over the held unknowns. Nothing but the
  /// accuracy of the solution, better than 1e-10, makes it balance what is applied.
  Resultant reactions() const;

 private:
  std::vector<PointState> states(Index element, const Eigen::VectorXd& xi,
                                 const Eigen::VectorXd& zeta) const;

  std::shared_ptr<const Model> model_;
  Eigen::VectorXd displacements_;
  Eigen::VectorXd applied_forces_;
  Eigen::VectorXd support_forces_;
};

}  // namespace block
