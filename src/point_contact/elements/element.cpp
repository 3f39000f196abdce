// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/elements/element.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "point_contact/elements/patch.hpp"
#include "system/require.hpp"

namespace point_contact {
namespace {

Lattice checked(Element element, const Lattice& lattice) {
  const double area = lattice.cell_area();
  if (!(std::isfinite(area) && area > 0)) {
    throw sys::InvalidQuantity("cell area", area, "finite and greater than 0");
  }
  if (element == Element::bilinear && !lattice.is_rectangular()) {
    const double cosine = lattice.first.normalized().dot(lattice.second.normalized());
    throw sys::InvalidQuantity("cosine of the angle between the lattice's vectors", cosine,
                               "0 for bilinear elements");
  }
  return lattice.normalised();
}

std::vector<Vector2> directions(Element element, const Lattice& lattice) {
  const Vector2& a = lattice.first;
  const Vector2& b = lattice.second;
  switch (element) {
    case Element::point:
      return {};
    case Element::uniform:
      return {a, b};
    case Element::bilinear:
      return {a, a, b, b};
    case Element::pyramid:
      break;
  }
  return {a, b, b - a};
}

// −Σ′ 1/|d| over a lattice with cells of area 1, less the integral that makes it diverge. Ewald:
// the part erfc(κr)/r is summed over the lattice, the rest over the reciprocal lattice.
double ewald_self_value(const Lattice& lattice) {
  const double kappa = std::sqrt(std::numbers::pi);  // both sums then converge alike
  const double turn = 2 * std::numbers::pi / cross(lattice.first, lattice.second);
  const Vector2 reciprocal1 = turn * Vector2(lattice.second.y(), -lattice.second.x());
  const Vector2 reciprocal2 = turn * Vector2(-lattice.first.y(), lattice.first.x());
  const double shortest = std::min(lattice.first.norm(), lattice.second.norm());
  const int n = 8 + static_cast<int>(8 / shortest);  // erfc(κ 4) < 1e-21
  double sum = -2 * kappa / std::sqrt(std::numbers::pi) - 2 * std::sqrt(std::numbers::pi) / kappa;
  for (int i = -n; i <= n; ++i) {
    for (int j = -n; j <= n; ++j) {
      if (i == 0 && j == 0) continue;
      const double r = (i * lattice.first + j * lattice.second).norm();
      const double q = (i * reciprocal1 + j * reciprocal2).norm();
      sum += std::erfc(kappa * r) / r + 2 * std::numbers::pi * std::erfc(q / (2 * kappa)) / q;
    }
  }
  return -sum;
}

double uniform_near(const Lattice& lattice, const Vector2& d) {
  const Vector2 a = lattice.first / 2;
  const Vector2 b = (cross(lattice.first, lattice.second) > 0 ? 0.5 : -0.5) * lattice.second;
  const std::array<Vector2, 4> corners = {-a - b, a - b, a + b, b - a};
  return uniform_potential(corners, d);
}

// begin excerpt: pyramid
// The six triangles that meet at the node, where the pressure is 1.
double pyramid_near(const Lattice& lattice, const Vector2& d) {
  const Vector2& a = lattice.first;
  const Vector2& b = lattice.second;
  const std::array<Vector2, 6> ring = {a, b, b - a, -a, -b, a - b};
  const bool is_counter_clockwise = cross(a, b) > 0;
  double sum = 0;
  for (std::size_t i = 0; i < 6; ++i) {
    const Vector2& one = ring[i];
    const Vector2& next = ring[(i + 1) % 6];
    sum += is_counter_clockwise ? linear_potential({Vector2::Zero(), one, next}, {1, 0, 0}, d)
                                : linear_potential({Vector2::Zero(), next, one}, {1, 0, 0}, d);
  }
  return sum;
}
// end excerpt: pyramid

// The differences of F keep a part of some (ab)²/r⁴ of it. Its digits are lost, three of them with
// cells ten times as long as wide, so that F is computed with more than those of a double.
using Extended = long double;

// F with ∂²/∂x² ∂²/∂y² F = 1/r.
Extended fourth_integral(Extended x, Extended y) {
  x = std::abs(x);
  y = std::abs(y);
  const Extended r = std::hypot(x, y);
  const Extended along_x = x > 0 ? x * x * y * std::asinh(y / x) : 0;
  const Extended along_y = y > 0 ? x * y * y * std::asinh(x / y) : 0;
  return (along_x + along_y) / 2 - r * r * r / 6;
}

double bilinear_near(const Lattice& lattice, const Vector2& d) {
  const Extended a = lattice.first.norm();
  const Extended b = lattice.second.norm();
  const Extended x = d.dot(lattice.first) / lattice.first.norm();
  const Extended y = d.dot(lattice.second) / lattice.second.norm();
  Extended sum = 0;
  for (const int i : {-1, 0, 1}) {
    for (const int j : {-1, 0, 1}) {
      const int weight = (i == 0 ? -2 : 1) * (j == 0 ? -2 : 1);
      sum += static_cast<Extended>(weight) *
             fourth_integral(x + static_cast<Extended>(i) * a, y + static_cast<Extended>(j) * b);
    }
  }
  return static_cast<double>(sum / (a * b));
}

}  // namespace

std::string_view name_of(Element element) {
  switch (element) {
    case Element::point:
      return "point";
    case Element::uniform:
      return "uniform";
    case Element::bilinear:
      return "bilinear";
    case Element::pyramid:
      break;
  }
  return "pyramid";
}

ElementPotential::ElementPotential(Element element, const Lattice& lattice)
    : element_(element),
      lattice_(checked(element, lattice)),
      far_(directions(element, lattice_)),
      self_value_(element == Element::point ? ewald_self_value(lattice_) : 0) {}

double ElementPotential::operator()(const Vector2& d) const {
  if (element_ == Element::point) {
    return d.x() == 0 && d.y() == 0 ? self_value_ : 1 / d.norm();
  }
  return d.squaredNorm() < far_.begin() * far_.begin() ? near(d) : far_.potential(d);
}

double ElementPotential::near(const Vector2& d) const {
  switch (element_) {
    case Element::uniform:
      return uniform_near(lattice_, d);
    case Element::bilinear:
      return bilinear_near(lattice_, d);
    default:
      return pyramid_near(lattice_, d);
  }
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
