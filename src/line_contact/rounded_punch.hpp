// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace line_contact {

/// A flat punch whose edges are rounded, h = κ(|x| − b)²/2 for |x| > b and 0 between: in closed
/// form, after Ciavarella, Hills and Monno (1998), The influence of rounded edges on indentation by
/// a flat punch, Proc. Instn Mech. Engrs C 212, 319–328.
///
/// b = 0 is Hertz. Below, a is the half-width of the contact, w = √(a²−b²) and ψ = arccos(b/a),
/// their π/2 − φ₀.
class RoundedPunch {
 public:
  /// contact_modulus E* (stress), flat_half_width b ≥ 0 (length), edge_curvature κ = 1/R (1/length)
  /// and line_load P (force per unit length) > 0, or InvalidQuantity is thrown.
  RoundedPunch(double contact_modulus, double flat_half_width, double edge_curvature,
               double line_load);

  /// The edge curvature κ = 2P/(E*(a²ψ − b w)), 1/length, that gives a contact of half-width a > b
  /// under the load P. Accuracy: relative, a few ε times a²ψ/(a²ψ − b w), which grows as a → b.
  /// Throws InvalidQuantity for arguments not in the constructor's range and unless a > b.
  static double edge_curvature_for(double contact_modulus, double flat_half_width,
                                   double half_width, double line_load);

  /// a, the root of P = (E*κ/2) (a²ψ − b w), and a − b > 0; lengths. Accuracy: 1e-15 relative, of
  /// a − b also where it is lost beside b and half_width() rounds to b.
  double half_width() const { return half_width_; }
  double overhang() const { return overhang_; }
  double line_load() const { return line_load_; }

  /// The largest pressure, a stress: at two points b < |x| < a, or at x = 0 where b = 0. Accuracy:
  /// 1e-15 relative.
  double peak_pressure() const;

  /// p(x) for |x| ≤ a, 0 outside; a stress. With r = √(a²−x²), x ≥ 0,
  ///
  ///   p = (E*κ/π) [ψ r + (x−b) arsinh(min(xw, br)/(a√|x²−b²|)) − b arsinh(wr/(a(b+x)))],
  ///
  /// finite at x = b, where its slope is infinite as −ln|x−b|.
  /// Accuracy: 1e-14 relative, given b and the rounded a − b, for (a−b)/b from 1e-16 to 1e16 and
  /// |x| to within 1e-15 (a−b) of the edge, against 60-digit arithmetic.
  double pressure(double x) const;

  /// The gap u_z1 + u_z2 + h − δ that is left outside the contact, 0 inside; a length. With
  /// R = √(x²−a²), x > 0,
  ///
  ///   (κ/π) [xRψ − (a²ψ − bw) arcosh(x/a) + (x−b)² arctan(bR/(xw)) − 2bx arctan(wR/(a²+bx))].
  ///
  /// Accuracy: absolute, 1e-15 (h(x) + P/E*): near the edge the gap is of order R³, a difference.
  double gap(double x) const;

 private:
  double to_edge(double x) const;
  double pressure_under_flat(double x, double r) const;
  double pressure_beyond_flat(double distance, double r) const;

  double flat_half_width_;
  double edge_curvature_;
  double line_load_;
  double pressure_scale_;  // E*κ/π
  double chord_;           // w
  double half_width_;
  double overhang_;
  double angle_;  // ψ
};

}  // namespace line_contact
