// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <string_view>

namespace line_contact {

/// The element that represents the pressure around a node. Each carries the load c·p, with the
/// spacing c.
enum class Element {
  point,      ///< a concentrated force: infinite displacement under it
  uniform,    ///< a pressure p over one spacing: infinite gradient at its ends
  triangular  ///< a triangle of height p over two spacings (Fig. 2 of the paper): smooth
};

/// The element's name in messages and on the command line.
std::string_view name_of(Element element);

/// The displacement k spacings away, T(k): u_z1 + u_z2 = −(2c/(πE*)) Σ_j T(k_j) p_j + constant.
///
///   triangular  Φ(k), eq. (3) (elasticity::triangle_potential)
///   uniform     Ψ(k)          (elasticity::strip_potential)
///   point       ln|k|, and T(0) = −ln 2π instead of −∞: the value that lets a row of forces
///               replace a smooth pressure (Sidi & Israeli 1988, J. Sci. Comput. 3, 201)
///
/// Lengths in the logarithm are in spacings. Any finite k; dimensionless. Accuracy: relative 1e-14
/// at whole k up to 1e9, between them that of elasticity::triangle_potential.
double influence_coefficient(Element element, double k);

/// T(k+1) − T(k) for whole k ≥ 0. Accuracy: 1e-14 relative; subtracting two coefficients would lose
/// one digit per digit of k.
double influence_difference(Element element, Eigen::Index k);

}  // namespace line_contact
