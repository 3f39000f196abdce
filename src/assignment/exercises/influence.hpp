// SPDX-License-Identifier: GPL-3.0-or-later
// Exercise 4: influence coefficients. This header is part of the handout.
#pragma once

namespace exercise {

/// The influence coefficient A_k: the displacement u_z1 + u_z2 of two surfaces k spacings away from
/// the peak of a triangle of pressure 1 Pa, whose half-width is the spacing c. It is zero at the
/// distance datum. By eq. (3), with E* instead of E/(1−ν²),
///
///   A_k = −[2c/(πE*)] [T(k) − T(datum/c)],
///   T(k) = ½[(k+1)² ln|k+1| + (k−1)² ln|k−1| − 2k² ln|k|] − 3/2.
///
/// k may be negative. T must be accurate to a relative 10⁻⁹ up to k = 10⁵.
double influence_coefficient(double contact_modulus, double spacing, double datum, int k);

}  // namespace exercise
