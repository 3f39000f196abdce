// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace block {

/// The cross-section of the block, |x| ≤ width/2 and 0 ≤ z ≤ height; its top z = 0 carries the
/// load.
class Rectangle {
 public:
  /// width and height (lengths), both finite and > 0, or InvalidQuantity is thrown.
  Rectangle(double width, double height);

  double width() const { return width_; }
  double height() const { return height_; }
  double left() const { return -width_ / 2; }
  double right() const { return width_ / 2; }

 private:
  double width_;
  double height_;
};

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

/// How one side of the block is held.
enum class Support {
  free,    ///< no traction
  roller,  ///< no normal displacement, no shear
  clamped  ///< no displacement
};

/// How the block is held on three sides; the bottom is clamped by default. The top is free.
struct Supports {
  Support left = Support::free;
  Support right = Support::free;
  Support bottom = Support::clamped;
};

/// The block held alike on its left and right, with the bottom clamped: the cases of the report.
Supports with_sides(Support sides);

/// Throws InvalidQuantity unless the supports prevent all three rigid motions.
///
/// Any side that is held prevents the rotation, since a line stays in place. A translation can be
/// left: that along x if left and right are free and the bottom is not clamped, that along z if the
/// bottom is free and no side clamped.
void require_no_rigid_motion(const Supports& supports);

}  // namespace block
