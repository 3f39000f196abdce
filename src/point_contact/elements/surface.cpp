// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/elements/interior.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>

#include "point_contact/elements/patch.hpp"

namespace point_contact {
namespace {

double cube(double x) {
  return x * x * x;
}

// One end of an edge: the primitives of ln(r/l), s ln(r/l) and w, r² = h² + s², at its coordinate
// s.
struct LogarithmAt {
  double of_log;
  double of_s_log;
  double of_w;

  LogarithmAt(double s, double h, double length) {
    const double r = std::hypot(s, h);
    const double log = r == 0 ? 0 : std::log(r / length);  // its factors are then 0
    const double angle = h == 0 ? 0 : std::atan(s / h);
    of_log = s * (log - 1) + h * angle;
    of_s_log = r * r * (log / 2 - 0.25);
    // ∫ s² ln r ds by parts, with s⁴/r² = s² − h² + h⁴/r²
    const double of_s2_log = (cube(s) * log - cube(s) / 3 + h * h * s - cube(h) * angle) / 3;
    of_w = (h * h * of_log + of_s2_log) / 2 - (h * h * s + cube(s) / 3) / 4;
  }
};

// ∫ p (P−Q)/r² dA.
Vector2 inward_pull(const Patch& patch, const Vector2& at) {
  const auto& [value, g, hessian] = patch.about(at);
  const std::span<const Vector2> corners = patch.corners();

  // The unit of the logarithm changes nothing; the farthest corner makes it small.
  double length = 0;
  for (const Vector2& corner : corners) length = std::max(length, (corner - at).norm());

  double area_log = 0;                 // ∫ ln r dA
  Vector2 edge_log = Vector2::Zero();  // Σ n ∫ p ln r ds
  Vector2 edge_w = Vector2::Zero();    // Σ n ∫ w ds
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Vector2 to_begin = corners[k] - at;
    const Vector2 to_end = corners[(k + 1) % corners.size()] - at;
    const Vector2 tangent = (to_end - to_begin).normalized();
    const Vector2 normal(tangent.y(), -tangent.x());
    const double h = (to_begin.norm() < to_end.norm() ? to_begin : to_end).dot(normal);
    const double s1 = to_begin.dot(tangent);
    const double s2 = to_end.dot(tangent);
    const LogarithmAt begin(s1, h, length);
    const LogarithmAt end(s2, h, length);
    const double log = end.of_log - begin.of_log;
    const double s_log = end.of_s_log - begin.of_s_log;
    const double rise = g.dot(tangent) + h * normal.dot(hessian * tangent);  // of p along s
    area_log += h * (log - (s2 - s1) / 2) / 2;
    edge_log += normal * ((value + h * g.dot(normal)) * log + rise * s_log);
    edge_w += normal * (end.of_w - begin.of_w);
  }
  return g * area_log + hessian * edge_w - edge_log;
}

// ∫ p dA/r.
double potential(const Patch& patch, const Vector2& at) {
  const auto& [value, g, hessian] = patch.about(at);
  const std::span<const Vector2> corners = patch.corners();
  double sum = 0;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const EdgeIntegrals e = edge_integrals(corners[k], corners[(k + 1) % corners.size()], at);
    sum += value * e.angular + g.dot(e.normal) * e.first_moment +
           e.normal.dot(hessian * e.tangent) * e.rise_of_cube / 2;
  }
  return sum;
}

}  // namespace

Eigen::Vector3d surface_displacement(const Patch& patch, const elasticity::Material& material,
                                     const Vector2& at) {
  const Vector2 tangential =
      -material.local_compliance() / (2 * std::numbers::pi) * inward_pull(patch, at);
  const double normal = material.integral_compliance() / 2 * potential(patch, at);
  return {tangential.x(), tangential.y(), normal};
}

Vector2 surface_gradient(const Patch& patch, const Vector2& at) {
  const auto& [value, g, hessian] = patch.about(at);
  const std::span<const Vector2> corners = patch.corners();
  double uniform = 0;                // ∫ dA/r
  Vector2 linear = Vector2::Zero();  // ∫ (Q−P)/r dA
  Vector2 edges = Vector2::Zero();   // Σ n ∫ p/r ds
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const EdgeIntegrals e = edge_integrals(corners[k], corners[(k + 1) % corners.size()], at);
    uniform += e.angular;
    linear += e.first_moment * e.normal;
    const double p_h = value + e.distance * g.dot(e.normal);
    const double rise = g.dot(e.tangent) + e.distance * e.normal.dot(hessian * e.tangent);
    edges += (p_h * e.inverse + rise * e.rise) * e.normal;
  }
  return uniform * g + hessian * linear - edges;
}

}  // namespace point_contact
