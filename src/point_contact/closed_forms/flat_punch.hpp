// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace point_contact {

/// A rigid cylinder's flat end pressed into a half-space: Boussinesq's closed form (Johnson §3.4,
/// eqs. 3.34–3.38).
class FlatPunch {
 public:
  /// contact_modulus E* (a stress), radius a and load P (a force), each > 0, or InvalidQuantity is
  /// thrown.
  FlatPunch(double contact_modulus, double radius, double load);

  /// δ = P/(2aE*), a length (Johnson 3.36).
  double approach() const { return approach_; }

  /// p(r) = P/(2πa √(a²−r²)) for r < a, infinite at the edge, 0 outside; a stress (Johnson 3.34).
  double pressure(double r) const;

  /// u_z1 + u_z2 = δ for r ≤ a, (2δ/π) arcsin(a/r) outside; a length (Johnson 3.37, 3.38).
  double displacement(double r) const;

 private:
  double radius_;
  double load_;
  double approach_;
};

}  // namespace point_contact
