// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "line_contact/graded_grid.hpp"
#include "line_contact/profile.hpp"

namespace line_contact {

/// Pressures at the nodes of a graded grid that ends on the edges of contact, which it found.
///
/// On each element the pressure is linear between its nodes, plus a parabola of height `bulge`.
struct GradedSolution {
  Edges edges;
  Eigen::VectorXd x;              ///< nodes, rising, from edges.left to edges.right; lengths
  Eigen::VectorXd pressure;       ///< p at the nodes, stress; 0 at both ends
  Eigen::VectorXd bulge;          ///< parabola's height at the middle of each element, stress
  double contact_modulus;         ///< E*, stress
  double approach_at_half_width;  ///< δ when lengths in the logarithm are taken in half_width()
  int n_iterations;               ///< steps of the edges until they no longer moved
  double misfit;  ///< greatest |u_z1 + u_z2 + h − δ| at the nodes, eq. (1a), a length

  double half_width() const { return (edges.right - edges.left) / 2; }

  /// p(x) of the elements, a stress: any x, 0 outside the contact.
  double pressure_at(double at) const;

  /// The greatest pressure of the elements, at a node or in between, a stress. It is finite even
  /// where the true one is not, under the point of a wedge.
  double peak_pressure() const;

  /// ∫ p dx over the elements, force per unit length.
  double line_load() const;

  /// The approach δ of points of the two surfaces that lie at x = datum, where u_z1 = u_z2 = 0; a
  /// length, any finite datum:
  ///   δ = δ_a + (2/(πE*)) ∫ p(s) ln(|datum − s|/a) ds,  δ_a = approach_at_half_width.
  /// Eq. (1a) says that it is h(datum) in contact, and by (1b) h(datum) less this is the gap
  /// outside.
  double approach(double datum) const;
};

inline constexpr long min_graded_elements = 4;  ///< over the half-width

/// The last element is 1.9 a/n⁴ wide: beyond, rounding shows in the pressures on it.
inline constexpr long max_graded_elements = 500;

/// Solves a frictionless contact in one region on a grid whose last elements end on its edges.
///
/// Nodes at x = centre + a sin(½π sin θ), θ even from −½π to ½π, 2 n_elements elements in all. The
/// pressure, a root of the distance from an edge, is then as well interpolated there as elsewhere:
/// to 0.97/n² of the peak by straight lines. Unequal triangles alone find the half-width to 0.3/n³
/// but the peak only to 0.5/n². So each element has a parabola too, which adds no unknown: its
/// height takes p/√((x−left)(right−x)) at the middle by the cubic through four nodes around it.
/// Eq. (1a) holds at every node, the edges included, and ∫ p dx = P; the edges are where that
/// leaves no pressure at either (Newton's method, its steps at most half the half-width).
///
/// `line_load` P > 0, force per unit length; `contact_modulus` E* > 0, stress; n_elements over the
/// half-width, from min_graded_elements to max_graded_elements; `start`, finite, left < right, is
/// cut to where the profile is given. For a convex profile every start tried will do; others may
/// have several places of contact, of which the start chooses.
///
/// Accuracy against Hertz: half-width 0.30/n⁴, peak 0.12/n⁴, pressure at the nodes 0.23/n² of the
/// peak (half-width's error, seen through the infinite slope at the edge), between them 0.51/n²:
/// with n = 100 elements 3.0e-9, 1.2e-9, 2.3e-5 and 5.1e-5. Rounding ends this at n = 300 with
/// 2e-6, and leaves 1e-5 at n = 500. Where the profile has a kink or a jump of curvature the
/// pressure next to it has order one, the half-width order two (wedge, 0.5/n²) or better (rounded
/// punch).
///
/// Throws InvalidQuantity for inputs out of range, and ContactError when the edges do not settle or
/// reach the ends of a tabulated profile, or when there is tension in between or penetration
/// beyond: the contact then is not one region.
GradedSolution solve_on_graded_grid(const Profile& profile, double contact_modulus,
                                    double line_load, long n_elements, Edges start);

}  // namespace line_contact
