// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "elasticity/material.hpp"
#include "line_contact/profile.hpp"

namespace line_contact {

/// The shape of a body near the point of first contact: a cylinder, a plane or a cylindrical
/// hollow.
class Radius {
 public:
  /// A cylinder of radius > 0, or a hollow that the other body lies in, radius < 0 (a length).
  /// Throws InvalidQuantity for `name` if the radius is 0 or not finite.
  static Radius of_cylinder(const char* name, double radius);

  /// A plane, whose curvature is 0.
  static Radius of_plane() { return Radius(0); }

  bool is_plane() const { return curvature_ == 0; }
  double curvature() const { return curvature_; }  ///< 1/R, 1/length; 0 for a plane

 private:
  explicit Radius(double curvature) : curvature_(curvature) {}
  double curvature_;
};

/// Two elastic cylinders with parallel axes, touching along a line.
class CylinderPair {
 public:
  /// Throws InvalidQuantity unless 1/R₁ + 1/R₂ > 0: otherwise the bodies do not touch at a point.
  CylinderPair(const elasticity::Material& material1, Radius radius1,
               const elasticity::Material& material2, Radius radius2);

  /// 1/R = 1/R₁ + 1/R₂, 1/length (Johnson 4.19).
  double relative_curvature() const { return relative_curvature_; }

  /// E*, 1/E* = (1−ν₁²)/E₁ + (1−ν₂²)/E₂, stress (Johnson 4.22).
  double contact_modulus() const { return contact_modulus_; }

  /// The gap before deformation h(x) = x²/(2R), a length: the paper's h in eqs. (1a) and (1b).
  Profile profile() const { return Profile::parabola(relative_curvature_); }

 private:
  double relative_curvature_;
  double contact_modulus_;
};

}  // namespace line_contact
