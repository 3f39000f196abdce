// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace point_contact {

/// The principal curvatures of a body's surface at the point of contact, reciprocals of lengths:
/// positive for a convex surface, 0 along a cylinder, negative for a hollow.
struct PrincipalCurvatures {
  double first;
  double second;
};

/// The gap between two bodies close to where they touch, h = (κ_x x² + κ_y y²)/2 in its own
/// principal axes.
struct RelativeCurvatures {
  double x;      ///< κ_x, the smaller: the contact is longest along x
  double y;      ///< κ_y
  double angle;  ///< from the first body's first principal direction to the x axis, radians
};

/// The relative curvatures of two bodies whose first principal directions stand at `angle`:
///
///   κ_x + κ_y = Σκ,  (κ_y − κ_x) = |Δ₁ + Δ₂ e^{2i angle}|,  Δ = first − second   (Johnson 4.3)
///
/// Throws InvalidQuantity unless both κ are positive: else the bodies touch along a line or at more
/// than one point.
RelativeCurvatures relative_curvatures(PrincipalCurvatures body1, PrincipalCurvatures body2,
                                       double angle);

}  // namespace point_contact
