// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/elements/interior.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>

#include "system/require.hpp"

namespace point_contact {
namespace {

// The primitives of an edge's integrals at one of its ends; the coordinate s runs along the edge, h
// is the distance in the plane from the edge's line, positive inside, ρ² = h² + s² + z².
struct EdgeEnd {
  double s;
  double rho;
  double log;    // ln(ρ+z), the primitive of s/[ρ(ρ+z)]
  double angle;  // of h/[ρ(ρ+z)]: arctan(s/h) − arctan(sz/(hρ)), as one arc tangent

  EdgeEnd(double along, double h, double z)
      : s(along),
        rho(std::sqrt(h * h + along * along + z * z)),
        log(std::log(rho + z)),
        angle(std::atan2(s * h * (h * h + s * s) / (rho + z), h * h * rho + s * s * z)) {}
};

// Integrals along an edge, from its begin to its end.
struct EdgeSums {
  double inverse;        // Λ = ∫ ds/ρ
  double distance;       // ∫ ρ ds
  double s_distance;     // ∫ s ρ ds
  double s;              // [s], its length
  double rho;            // [ρ], of s/ρ
  double inverse_cubed;  // ∫ ds/ρ³
  double s_inverse_cubed;
  double s2_inverse_cubed;
  double log;         // ∫ s/[ρ(ρ+z)] ds
  double angle;       // A = h ∫ ds/[ρ(ρ+z)]
  double s2;          // ∫ s²/[ρ(ρ+z)] ds
  double of_log;      // M = ∫ ln(ρ+z) ds
  double s_of_log;    // ∫ s ln(ρ+z) ds
  double of_rho_log;  // ∫ W ds, W = ∫ ρ ln(ρ+z) dρ
};

// ∫ ds/ρ by the difference of its arguments where both ends are on one side.
double inverse_distance(const EdgeEnd& begin, const EdgeEnd& end, double distance_from_line) {
  if (begin.s < 0 && end.s > 0) {
    return std::asinh(end.s / distance_from_line) + std::asinh(-begin.s / distance_from_line);
  }
  const bool is_forward = begin.s >= 0;
  const EdgeEnd& near = is_forward ? begin : end;
  const EdgeEnd& far = is_forward ? end : begin;
  const double rise_of_s = std::abs(far.s) - std::abs(near.s);
  const double rise_of_rho =
      rise_of_s * (std::abs(far.s) + std::abs(near.s)) / (far.rho + near.rho);
  return std::log1p((rise_of_s + rise_of_rho) / (std::abs(near.s) + near.rho));
}

EdgeSums edge_sums(double h, double z, const EdgeEnd& begin, const EdgeEnd& end) {
  const double square = h * h + z * z;
  EdgeSums e{};
  e.inverse = inverse_distance(begin, end, std::sqrt(square));
  e.s = end.s - begin.s;
  e.rho = (end.s - begin.s) * (end.s + begin.s) / (end.rho + begin.rho);
  e.distance = (end.s * end.rho - begin.s * begin.rho + square * e.inverse) / 2;
  e.s_distance = e.rho * (end.rho * end.rho + end.rho * begin.rho + begin.rho * begin.rho) / 3;
  const double slope = end.s / end.rho - begin.s / begin.rho;
  e.inverse_cubed = slope / square;
  e.s_inverse_cubed = 1 / begin.rho - 1 / end.rho;
  e.s2_inverse_cubed = e.inverse - slope;
  e.log = end.log - begin.log;
  e.angle = end.angle - begin.angle;
  e.s2 = e.s - z * e.inverse - h * e.angle;
  e.of_log = end.s * end.log - begin.s * begin.log - e.s2;
  const auto primitive = [z](const EdgeEnd& at) {
    return (at.rho - z) * ((at.rho + z) * at.log / 2 - (at.rho - z) / 4);
  };
  e.s_of_log = primitive(end) - primitive(begin);

  // W = ½(h²+s²) ln(ρ+z) − ¼(ρ−z)². By parts ∫ s² ln(ρ+z) ds needs ∫ s⁴/[ρ(ρ+z)] ds.
  const auto cube = [](double x) { return x * x * x; };
  const double cubes = (cube(end.s) - cube(begin.s)) / 3;
  const double s2_inverse = e.distance - square * e.inverse;  // ∫ s²/ρ ds
  const double s4 = cubes - h * h * e.s - z * (s2_inverse - h * h * e.inverse) + cube(h) * e.angle;
  const double s2_of_log = (cube(end.s) * end.log - cube(begin.s) * begin.log - s4) / 3;
  const double squares = cubes + (h * h + 2 * z * z) * e.s - 2 * z * e.distance;  // ∫ (ρ−z)² ds
  e.of_rho_log = (h * h * e.of_log + s2_of_log) / 2 - squares / 4;
  return e;
}

// φ and ψ with their derivatives; indices 0 and 1 stand for x and y.
struct Potentials {
  double phi = 0;
  Vector2 phi_i = Vector2::Zero();
  double phi_z = 0;
  Eigen::Matrix2d phi_ij = Eigen::Matrix2d::Zero();
  Vector2 phi_iz = Vector2::Zero();
  Vector2 psi_i = Vector2::Zero();
  Eigen::Matrix2d psi_ij = Eigen::Matrix2d::Zero();
};

Potentials potentials(const Patch& patch, const Vector2& at, double z) {
  const auto& [value, g, hessian] = patch.about(at);
  const std::span<const Vector2> corners = patch.corners();
  Potentials sum;
  // of the uniform pressure 1: φ⁰, its gradient and ψ⁰
  double uniform = 0;
  Vector2 uniform_i = Vector2::Zero();
  double solid_angle = 0;
  double uniform_psi = 0;
  Vector2 linear = Vector2::Zero();      // ∫ (Q−P)/ρ dA
  Vector2 linear_psi = Vector2::Zero();  // ∫ (Q−P) ln(ρ+z) dA
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Vector2 to_begin = corners[k] - at;
    const Vector2 to_end = corners[(k + 1) % corners.size()] - at;
    const Vector2 t = (to_end - to_begin).normalized();
    const Vector2 n(t.y(), -t.x());
    const double h = (to_begin.norm() < to_end.norm() ? to_begin : to_end).dot(n);
    const EdgeSums e =
        edge_sums(h, z, EdgeEnd(to_begin.dot(t), h, z), EdgeEnd(to_end.dot(t), h, z));

    // On the edge Q−P = h n + s t, p = p_h + g_t s and ∇p = g_h + s Ht.
    const Vector2 bend = hessian * t;
    const double twist = n.dot(bend);
    const Vector2 g_h = g + h * (hessian * n);
    const double p_h = value + h * g.dot(n);
    const double g_t = g.dot(t) + h * twist;
    const double polar = h * e.inverse - z * e.angle;  // ∫ (ρ−z) dθ
    uniform += polar;
    uniform_i -= e.inverse * n;
    solid_angle += e.angle;
    uniform_psi += h * (e.of_log / 2 - e.s / 4) + z * polar / 2;
    linear += e.distance * n;
    linear_psi += e.of_rho_log * n;

    sum.phi += e.distance * g.dot(n) + e.s_distance * twist / 2;
    sum.phi_z += z * (e.inverse * g.dot(n) + e.rho * twist / 2);
    sum.phi_i -= (p_h * e.inverse + g_t * e.rho) * n;
    const Vector2 cubed = h * (p_h * e.inverse_cubed + g_t * e.s_inverse_cubed) * n +
                          (p_h * e.s_inverse_cubed + g_t * e.s2_inverse_cubed) * t;
    sum.phi_ij -= n * cubed.transpose() + (e.inverse * g_h + e.rho * bend) * n.transpose();
    sum.phi_iz += z * (p_h * e.inverse_cubed + g_t * e.s_inverse_cubed) * n;
    sum.psi_i -= (p_h * e.of_log + g_t * e.s_of_log) * n;
    const Vector2 logs = (p_h * e.angle + g_t * h * e.log) * n + (p_h * e.log + g_t * e.s2) * t;
    sum.psi_ij += n * logs.transpose() - (e.of_log * g_h + e.s_of_log * bend) * n.transpose();
  }
  sum.phi += value * uniform;
  sum.phi_z -= value * solid_angle;
  sum.phi_i += uniform * g + hessian * linear;
  sum.phi_ij += uniform * hessian;
  sum.phi_iz += z * (hessian * -uniform_i) - solid_angle * g;
  sum.psi_i += uniform_psi * g + hessian * linear_psi;
  sum.psi_ij += uniform_psi * hessian;
  return sum;
}

}  // namespace

InteriorField& InteriorField::operator+=(const InteriorField& other) {
  displacement += other.displacement;
  stress += other.stress;
  return *this;
}

InteriorField interior_field(const Patch& patch, const elasticity::Material& material,
                             const Eigen::Vector3d& at) {
  const double z = at.z();
  if (!(std::isfinite(z) && z > 0)) {
    throw sys::InvalidQuantity("z", z, "greater than 0, a depth beneath the surface");
  }
  const double nu = material.poisson();
  const double shear_modulus = material.young() / (2 * (1 + nu));
  const Potentials f = potentials(patch, at.head<2>(), z);

  InteriorField field;
  field.displacement.head<2>() = -((1 - 2 * nu) * f.psi_i + z * f.phi_i);
  field.displacement.z() = 2 * (1 - nu) * f.phi - z * f.phi_z;
  field.displacement /= 4 * std::numbers::pi * shear_modulus;

  const Eigen::Matrix2d plane =
      2 * nu * f.phi_z * Eigen::Matrix2d::Identity() - z * f.phi_ij - (1 - 2 * nu) * f.psi_ij;
  field.stress.topLeftCorner<2, 2>() = (plane + plane.transpose()) / 2;
  field.stress.topRightCorner<2, 1>() = -z * f.phi_iz;
  field.stress.bottomLeftCorner<1, 2>() = -z * f.phi_iz.transpose();
  field.stress(2, 2) = f.phi_z + z * f.phi_ij.trace();  // φ_zz = −φ_xx − φ_yy
  field.stress /= 2 * std::numbers::pi;
  return field;
}

InteriorField field_of_force(double force, const elasticity::Material& material,
                             const Eigen::Vector3d& at) {
  const double z = at.z();
  sys::require_positive("z", z);
  const Vector2 d = at.head<2>();
  const double nu = material.poisson();
  const double shear_modulus = material.young() / (2 * (1 + nu));
  const double rho = at.norm();
  const double rho3 = rho * rho * rho;
  const double rho5 = rho3 * rho * rho;
  const double sum = rho + z;

  InteriorField field;
  field.displacement.head<2>() = (z / rho3 - (1 - 2 * nu) / (rho * sum)) * d;
  field.displacement.z() = z * z / rho3 + 2 * (1 - nu) / rho;
  field.displacement *= force / (4 * std::numbers::pi * shear_modulus);

  const double along = (1 - 2 * nu) * (z / rho3 - 1 / (rho * sum));
  const double across = (1 - 2 * nu) * (2 * rho + z) / (rho3 * sum * sum) - 3 * z / rho5;
  field.stress.topLeftCorner<2, 2>() =
      along * Eigen::Matrix2d::Identity() + across * d * d.transpose();
  field.stress.topRightCorner<2, 1>() = -3 * z * z / rho5 * d;
  field.stress.bottomLeftCorner<1, 2>() = field.stress.topRightCorner<2, 1>().transpose();
  field.stress(2, 2) = -3 * z * z * z / rho5;
  field.stress *= force / (2 * std::numbers::pi);
  return field;
}

}  // namespace point_contact
