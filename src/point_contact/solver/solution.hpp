// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "contact/solution.hpp"
#include "elasticity/material.hpp"
#include "point_contact/elements/interior.hpp"
#include "point_contact/solver/problem.hpp"

namespace point_contact {

/// Pressures at the nodes of a grid, and what follows from them. No function is inline, for the
/// reason that Grid::node() has.
struct Solution {
  Grid grid;
  Element element;
  Eigen::VectorXd pressure;  ///< p at the nodes, a stress; 0 outside contact
  Eigen::VectorXd gap;       ///< u_z1 + u_z2 + h − δ at the nodes, a length
  double approach;           ///< δ of points far away in the two bodies, a length
  contact::Work work;
  contact::Residuals residuals;

  Eigen::Index n_in_contact() const;

  /// The resultant, cell area times Σp, a force.
  double load() const;

  /// The greatest of the nodal pressures.
  double peak_pressure() const;

  /// The area of the cells of the nodes in contact.
  double contact_area() const;

  /// The semi-axes a ≥ b of the contact from the pressure's second moments M, a² and b² = 5 times
  /// the eigenvalues of M: right for the pressure of ellipsoids. The elements' own moments are
  /// included. Unlike the count of nodes they do not jump by c.
  Vector2 semi_axes() const;

  /// The semi-axes a ≥ b of the ellipse that has the second moments of the area in contact, for
  /// other bodies. Right to a fraction of c.
  Vector2 area_semi_axes() const;
};

/// What a method finds: element loads φ = c p/(πE*) and gaps at the nodes, lengths.
struct ElementLoads {
  Eigen::VectorXd phi;
  Eigen::VectorXd gap;
  double approach = 0;
  double error = 0;  ///< of φ, relative to the greatest
  contact::Work work;
};

/// Σφ for the load P: P/(πE*c), a length.
double total_phi(const Problem& problem, double load);

/// The loads as pressures, with their residuals. `load` is what was asked for, or what was found.
Solution to_solution(const Problem& problem, double load, ElementLoads loads);

/// A part of the surface in contact whose nodes are neighbours of one another.
struct Region {
  Vector2 centre;  ///< of its pressure
  double load;     ///< what it carries, a force
  double area;     ///< of its nodes' cells
  Eigen::Index n_nodes;
};

/// The regions in contact, those that carry most first. Neighbours of a node are the six at
/// ±first, ±second and ±(second − first), the corners of a pyramid's hexagon.
std::vector<Region> regions(const Solution& solution);

/// The displacements and stresses in the body beneath, of this material, at a depth z > 0 or
/// InvalidQuantity is thrown: the sum of interior_field() over what the elements' pressure is made
/// of, triangles between the nodes (pyramids), rectangles between them (bilinear) or the nodes'
/// cells (uniform), or of field_of_force() over the nodes (point). Cost: 1 µs for each triangle in
/// contact. Accuracy: the pressure's own; rounding grows with the square of the distance in
/// spacings, to 1e-10 of the field at a thousand.
InteriorField field_beneath(const Solution& solution, const elasticity::Material& material,
                            const Eigen::Vector3d& at);

/// The displacement (u_x, u_y, u_z) of the surface of the body of this material, by the same
/// pressure: the sum of surface_displacement(). InvalidQuantity is thrown at the nodes of forces,
/// where it is infinite.
Eigen::Vector3d displacement_of_surface(const Solution& solution,
                                        const elasticity::Material& material, const Vector2& at);

/// ∇(u_z1 + u_z2) at a point of the surface, by the same pressure: the sum of surface_gradient().
/// Throws InvalidQuantity where an element's own gradient is not finite: at the nodes of forces, on
/// the edges between cells, and, though the sum would be finite there, on the edges of the
/// triangles and rectangles of the others.
Vector2 slope_of_surface(const Solution& solution, double contact_modulus, const Vector2& at);

}  // namespace point_contact
