// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/element.hpp"

#include <gsl/gsl_integration.h>

#include <cmath>
#include <cstddef>
#include <vector>

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

namespace {

double uniform_near(const Vector2& d) {
  static const std::array<Vector2, 4> corners = {
      {{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}}};
  return uniform_potential(corners, d);
}

// The six triangles that meet at the node, where the pressure is 1.
double pyramid_near(const Vector2& d) {
  static const std::array<Vector2, 6> ring = {{{1, 0}, {0, 1}, {-1, 1}, {-1, 0}, {0, -1}, {1, -1}}};
  double sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    sum += linear_potential({Vector2::Zero(), ring[i], ring[(i + 1) % ring.size()]}, {1, 0, 0}, d);
  }
  return sum;
}

// An element as weighted points.
struct PointLoads {
  void add(const Vector2& at, double w) {
    x.push_back(at.x());
    y.push_back(at.y());
    weight.push_back(w);
  }

  double potential(const Vector2& d) const {
    double sum = 0;
    for (std::size_t i = 0; i < weight.size(); ++i) {
      const double dx = d.x() - x[i];
      const double dy = d.y() - y[i];
      sum += weight[i] / std::sqrt(dx * dx + dy * dy);
    }
    return sum;
  }

  std::vector<double> x, y, weight;
};

// Smears points along a vector, by Gauss's rule of n points.
PointLoads smeared(const PointLoads& points, const Vector2& along, std::size_t n) {
  PointLoads result;
  gsl_integration_glfixed_table* table = gsl_integration_glfixed_table_alloc(n);
  for (std::size_t k = 0; k < n; ++k) {
    double share = 0;
    double w = 0;
    gsl_integration_glfixed_point(-0.5, 0.5, k, &share, &w, table);
    for (std::size_t i = 0; i < points.weight.size(); ++i) {
      result.add(Vector2(points.x[i], points.y[i]) + share * along, w * points.weight[i]);
    }
  }
  gsl_integration_glfixed_table_free(table);
  return result;
}

PointLoads gauss_rule(Element element, std::size_t n) {
  PointLoads point;
  point.add({0, 0}, 1);
  PointLoads points = smeared(smeared(point, {1, 0}, n), {0, 1}, n);
  return element == Element::pyramid ? smeared(points, {-1, 1}, n) : points;
}

// The centre and the six corners of the hexagon, scaled by ρ = √(2/5): with the weights 3/8 and
// 5/48 they have the second and fourth moments of a pyramid. (On an equilateral lattice, of which
// ours is an affine image, these are isotropic: 3wρ² = 1/8 and 9/4 wρ⁴ = 3/80.) The error is of
// order d⁻⁶, as for Gauss's rule of 27 points.
PointLoads seven_point_rule() {
  PointLoads points;
  points.add({0, 0}, 3. / 8);
  const double rho = std::sqrt(0.4);
  for (const Vector2& corner : {Vector2(1, 0), Vector2(0, 1), Vector2(-1, 1)}) {
    points.add(rho * corner, 5. / 48);
    points.add(-rho * corner, 5. / 48);
  }
  return points;
}

// Rules with ever fewer points, each used beyond the distance where its error is below 2e-14.
class FarField {
 public:
  explicit FarField(Element element)
      : rules_{gauss_rule(element, 6), gauss_rule(element, 4), gauss_rule(element, 3),
               element == Element::pyramid ? seven_point_rule() : gauss_rule(element, 3)} {}

  double operator()(const Vector2& d, double square) const {
    constexpr std::array<double, 3> from = {20, 60, 120};
    std::size_t rule = 0;
    while (rule < from.size() && square >= from[rule] * from[rule]) ++rule;
    return rules_[rule].potential(d);
  }

 private:
  std::array<PointLoads, 4> rules_;
};

}  // namespace

std::string_view name_of(Element element) {
  return element == Element::uniform ? "uniform" : "pyramid";
}

double influence_coefficient(Element element, const Vector2& d) {
  static const FarField of_uniform(Element::uniform);
  static const FarField of_pyramid(Element::pyramid);
  const double square = d.squaredNorm();
  const bool is_near = square < 7 * 7;
  if (element == Element::uniform) return is_near ? uniform_near(d) : of_uniform(d, square);
  return is_near ? pyramid_near(d) : of_pyramid(d, square);
}

double uniform_potential(std::span<const Vector2> corners, const Vector2& at) {
  double sum = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    sum += edge_integrals(corners[i], corners[(i + 1) % corners.size()], at).angular;
  }
  return sum;
}

double linear_potential(const std::array<Vector2, 3>& corners, const std::array<double, 3>& values,
                        const Vector2& at) {
  double uniform = 0;
  Vector2 linear = Vector2::Zero();
  for (std::size_t i = 0; i < 3; ++i) {
    const EdgeIntegrals edge = edge_integrals(corners[i], corners[(i + 1) % 3], at);
    uniform += edge.angular;                    // ∫ dA/r
    linear += edge.first_moment * edge.normal;  // ∫ (Q−P)/r dA
  }

  // g from the rises of σ along two sides
  const Vector2 side1 = corners[1] - corners[0];
  const Vector2 side2 = corners[2] - corners[0];
  const double rise1 = values[1] - values[0];
  const double rise2 = values[2] - values[0];
  const Vector2 gradient =
      Vector2(rise1 * side2.y() - rise2 * side1.y(), rise2 * side1.x() - rise1 * side2.x()) /
      cross(side1, side2);
  return (values[0] + gradient.dot(at - corners[0])) * uniform + gradient.dot(linear);
}

}  // namespace point_contact
