// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace block {

/// The cross-section of the block, |x| ≤ width/2 and 0 ≤ z ≤ height, loaded on its top z = 0.
class Rectangle {
 public:
  /// width and height are lengths. Throws InvalidQuantity unless both are finite and > 0.
  Rectangle(double width, double height);

  double width() const { return width_; }
  double height() const { return height_; }
  double left() const { return -width_ / 2; }
  double right() const { return width_ / 2; }

 private:
  double width_;
  double height_;
};

/// Moments of inertia per unit thickness about three axes, mass times length squared.
///
/// Axes of Appendix 2: x along the surface, y up (−z in this project), z out of the plane. A plane
/// model has its mass in the plane z = 0, so izz = ixx + iyy; all products of inertia vanish.
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
/// m·width²/12, about the origin by Steiner's theorem. density ρ is mass per volume. Throws
/// InvalidQuantity unless ρ > 0. Exact.
MassProperties mass_properties(const Rectangle& block, double density);

/// The support of one side of the block.
enum class Support {
  free,    ///< no traction
  roller,  ///< no normal displacement, no shear
  clamped  ///< no displacement
};

/// The supports on three sides; the bottom is clamped by default. The top is free. They must
/// prevent all rigid motions.
struct Supports {
  Support left = Support::free;
  Support right = Support::free;
  Support bottom = Support::clamped;
};

/// The same support on the left and right, with the bottom clamped: the cases of the report.
Supports with_sides(Support sides);

}  // namespace block
