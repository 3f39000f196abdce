// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace line_contact {

/// The ends of a contact, left < right, lengths.
struct Edges {
  double left;
  double right;
};

/// The nodes of a contact of half-width 1 at x = sin(½π sin θ), θ even from −½π to ½π. They are
/// kept as distances from the nearer edge, so that two of them a billionth apart still have a
/// difference of full accuracy.
class ReferenceGrid {
 public:
  explicit ReferenceGrid(long n_elements);  ///< over the half-width

  Eigen::Index n_nodes() const { return from_edge_.size(); }
  Eigen::Index n_elements() const { return n_nodes() - 1; }

  /// From one node to another, negative to the left.
  double distance(Eigen::Index from, Eigen::Index to) const;
  double length(Eigen::Index element) const { return distance(element, element + 1); }

  /// √((x − left)(right − x)) at the node, and at the middle of the element.
  double root(Eigen::Index node) const;
  double middle_root(Eigen::Index element) const;

  /// Where the node lies in a contact with these edges.
  double x(Eigen::Index node, Edges edges) const;

 private:
  Eigen::VectorXd from_edge_;
};

/// Row e: the height of the parabola on element e above the mean of its nodes, as a sum of nodal
/// pressures. p/√((x − left)(right − x)) at the middle is taken from the cubic through four nodes.
Eigen::MatrixXd bulge_weights(const ReferenceGrid& grid);

/// Eq. (1a) at each node and equilibrium, for the contact of half-width 1 and so for any: with
/// φ = 2a p/(πE*), Σ V_ij φ_j + δ = h_i and Σ w_j φ_j = 2P/(πE*). The last column is that of δ.
Eigen::MatrixXd graded_system(const ReferenceGrid& grid, const Eigen::MatrixXd& bulge);

}  // namespace line_contact
