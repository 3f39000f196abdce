// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/elements/edge.hpp"

#include <cmath>

namespace point_contact {
namespace {

// ∫ ds/r from s₁ to s₂ > s₁ ≥ 0: ln[(s₂+r₂)/(s₁+r₁)], from the difference of its arguments.
double log_of_ratio(double s1, double r1, double s2, double r2) {
  const double rise_of_r = (s2 - s1) * ((s2 + s1) / (r2 + r1));
  return std::log1p(((s2 - s1) + rise_of_r) / (s1 + r1));
}

double inverse_distance_integral(double h, double s1, double r1, double s2, double r2) {
  if (s1 >= 0) return log_of_ratio(s1, r1, s2, r2);
  if (s2 <= 0) return log_of_ratio(-s2, r2, -s1, r1);
  return std::asinh(s2 / std::abs(h)) + std::asinh(-s1 / std::abs(h));
}

}  // namespace

EdgeIntegrals edge_integrals(const Vector2& begin, const Vector2& end, const Vector2& at) {
  const Vector2 tangent = (end - begin).normalized();
  const Vector2 normal(tangent.y(), -tangent.x());
  const Vector2 to_begin = begin - at;
  const Vector2 to_end = end - at;
  // The nearer end gives h with less rounding.
  const double r1 = to_begin.norm();
  const double r2 = to_end.norm();
  const double h = (r1 < r2 ? to_begin : to_end).dot(normal);
  const double s1 = to_begin.dot(tangent);
  const double s2 = to_end.dot(tangent);
  const double inverse = inverse_distance_integral(h, s1, r1, s2, r2);
  const double angular = h == 0 ? 0 : h * inverse;
  return {normal, angular, (s2 * r2 - s1 * r1 + h * angular) / 2};
}

}  // namespace point_contact
