// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

#include "block/mesh.hpp"
#include "block/model.hpp"
#include "elasticity/stress.hpp"

namespace block {

/// Displacement and stress at one point of the block.
struct PointState {
  Eigen::Vector2d position;      ///< x, z
  Eigen::Vector2d displacement;  ///< u_x, u_z; u_z positive into the body
  elasticity::Stress stress;
};

/// Coordinates ξ_k in [−1, 1] of elements and the basis there, computed once for many samples.
struct Abscissae {
  Abscissae(const LobattoBasis& basis, const Eigen::VectorXd& points);
  Eigen::VectorXd points;
  Eigen::MatrixXd values;       ///< N_i(ξ_k), a row for each k
  Eigen::MatrixXd derivatives;  ///< dN_i/dξ(ξ_k)
};

/// The displacement of the whole block under one load, and the quantities derived from it.
class Solution {
 public:
  /// Two vectors of size 2·n_nodes: displacements, and the nodal forces of the load.
  Solution(std::shared_ptr<const Model> model, Eigen::VectorXd displacements,
           const Eigen::VectorXd& load);

  const Model& model() const { return *model_; }

  /// u = Σ N_i u_i at any point of the block. Throws InvalidQuantity for a point outside.
  Eigen::Vector2d displacement(double x, double z) const { return at(x, z).displacement; }

  /// Displacement and stress at any point of the block. Stresses jump between elements by their
  /// discretisation error; on an edge, the result is that of the element on the right or below.
  /// Throws InvalidQuantity for a point outside.
  PointState at(double x, double z) const;

  /// The states at all points (ξ_k, ζ_l) of one element, k fastest.
  std::vector<PointState> sample(Index element, const Abscissae& xi, const Abscissae& zeta) const;

  /// ½∫ σ·ε dx dz, energy per unit thickness: half the load times the displacement.
  double strain_energy() const { return strain_energy_; }

  /// The force of the load, (x, z) per unit thickness.
  const Eigen::Vector2d& applied() const { return applied_; }

 private:
  std::shared_ptr<const Model> model_;
  Eigen::VectorXd displacements_;
  double strain_energy_;
  Eigen::Vector2d applied_;
};

/// One line of Appendix 2: its printed name and its value.
struct Measure {
  std::string name;
  double value;
};

/// The measures of Appendix 2 under their printed names, in the axes of that appendix: x along the
/// surface, y up (−z here), z out of the plane (y here).
///
/// max_disp_mag is |u|; max_disp_*, max_stress_* and max_prin_mag are the values of largest
/// magnitude with their sign, the leftmost if several agree to 1e-6; max_stress_prin and
/// min_stress_prin are the algebraically largest and least principal stresses, including σ_zz;
/// strain_energy is ½∫σ·ε per unit thickness, resultant_load_y the load. measure1, measure2, … are
/// −u_z at the given points of the top.
///
/// Stresses exclude the discs `left_out`. A maximum starts from the best of eleven by eleven points
/// per element and of points on the discs' circles; the search then climbs to within a thousandth
/// of their spacing. Throws InvalidQuantity for a point outside the block.
std::vector<Measure> measures(const Solution& solution, const std::vector<Disc>& left_out,
                              const std::vector<double>& surface_points = {});

}  // namespace block
