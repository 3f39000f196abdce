// SPDX-License-Identifier: GPL-3.0-or-later
// Exercise 5: two cylinders in contact. This header is part of the handout.
#pragma once

#include <vector>

#include "assignment/given/student_types.hpp"

namespace exercise {

/// Two cylinders with parallel axes; radii in m.
struct Cylinders {
  Material material1;
  double radius1;
  Material material2;
  double radius2;
};

/// Nodes x_i = (i − (n−1)/2) c, i = 0 … n−1, each at the peak of a triangle of half-width c.
struct Grid {
  int n_nodes;
  double spacing;  ///< c, m

  double x(int i) const { return (i - (n_nodes - 1) / 2.0) * spacing; }
};

struct Contact {
  double approach;               ///< δ, m
  double half_width;             ///< a, m
  std::vector<double> pressure;  ///< p_i at the nodes, Pa; 0 where the surfaces do not touch
};

/// The contact of two cylinders under the load P per unit length (N/m), eqs. (1a) and (1b):
///
///   Σ_j A_{i−j} p_j + h_i − δ = 0 and p_i > 0  at the nodes in contact,
///   Σ_j A_{i−j} p_j + h_i − δ ≥ 0 and p_i = 0  at the others,      c Σ_j p_j = P,
///
/// with h = (x²/2)(1/R₁ + 1/R₂) and 1/E* = (1−ν₁²)/E₁ + (1−ν₂²)/E₂. Solve linear equations for the
/// nodes assumed to be in contact, remove the nodes with negative pressure, and solve again until
/// there are none. a = 2√⟨x²⟩, where ⟨x²⟩ = Σ p_i (x_i² + c²/6) / Σ p_i is the second moment of the
/// pressure, including that of each triangle about its own peak.
Contact solve_contact(const Cylinders& cylinders, const Grid& grid, double datum, double line_load);

}  // namespace exercise
