// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "block/rectangle.hpp"

namespace block {

/// Moments of inertia of unit thickness about three axes, mass times length squared.
///
/// Axes of Appendix 2: x along the surface, y up (−z of this project), z out of the plane. A plane
/// model has its mass in the plane z = 0, so that izz = ixx + iyy; all products of inertia vanish.
struct Inertia {
  double ixx;
  double iyy;
  double izz;
};

/// Mass, centre of mass (0, centre_y) and inertia of the block, unit thickness.
struct MassProperties {
  double mass;
  double centre_y;
  Inertia about_origin;
  Inertia about_centre;
};

/// m = ρ·width·height, centre (0, −height/2), about the centre Ixx = m·height²/12 and Iyy =
/// m·width²/12, about the origin by Steiner. density ρ > 0 is mass per volume of unit thickness;
/// InvalidQuantity is thrown otherwise. Exact.
MassProperties mass_properties(const Rectangle& block, double density);

}  // namespace block
