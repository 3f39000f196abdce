// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <string_view>

namespace line_contact {

/// What stands at a node for the pressure around it. All carry the load c·p, c the spacing.
enum class Element {
  point,      ///< a concentrated force: infinite displacement under it
  uniform,    ///< a pressure p over one spacing: infinite gradient at its ends
  triangular  ///< a triangle of height p over two spacings (Fig. 2 of the paper): smooth
};

/// The element's name in messages and on the command line.
std::string_view name_of(Element element);

/// The displacement k spacings away, T(k): u_z1 + u_z2 = −(2c/(πE*)) Σ_j T(k_j) p_j + constant.
///
///   triangular  ½[(k+1)² ln|k+1| − 2k² ln|k| + (k−1)² ln|k−1|] − 3/2,  T(0) = −3/2, eq. (3)
///   uniform     (k+½) ln|k+½| − (k−½) ln|k−½| − 1                      (Johnson 2.30a)
///   point       ln|k|, and T(0) = −ln 2π instead of −∞: the value that makes a row of forces
///               stand for a smooth pressure (Sidi & Israeli 1988, J. Sci. Comput. 3, 201)
///
/// Lengths in the logarithm are in spacings. Any finite k; dimensionless. Accuracy: relative 1e-14
/// at whole k up to 1e9, absolute 1e-15 between, where T has a zero.
double influence_coefficient(Element element, double k);

/// T(k+1) − T(k) for whole k ≥ 0, relative accuracy 1e-14: the subtraction would lose a digit for
/// each digit of k.
double influence_difference(Element element, Eigen::Index k);

}  // namespace line_contact
