// SPDX-License-Identifier: GPL-3.0-or-later
// Boussinesq's integral ∫ p dA/r by quadrature in polar coordinates about the point, where the 1/r
// cancels with the area's r: what is left is bounded, and shares nothing with the closed forms.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>
#include <vector>

#include "numerics/quadrature.hpp"
#include "point_contact/elements/lattice.hpp"

using Pressure = std::function<double(const point_contact::Vector2&)>;

/// Where a ray of this angle crosses what makes a kink or an end of the pressure, in any order.
using Crossings = std::function<std::vector<double>(double angle)>;

/// ∫ p dA/r at a point for a pressure that is smooth between the crossings, and 0 beyond the last;
/// the crossings are smooth between these angles. The tolerance is for each ray and absolute.
inline double polar_potential(const Pressure& pressure, const Crossings& crossings,
                              std::vector<double> angles, const point_contact::Vector2& at,
                              double tolerance = 1e-11) {
  numerics::Quadrature outer, inner;
  const auto along_ray = [&](double angle) {
    const point_contact::Vector2 direction(std::cos(angle), std::sin(angle));
    const auto on_ray = [&](double s) {
      return pressure(point_contact::Vector2(at + s * direction));
    };
    std::vector<double> ends = crossings(angle);
    ends.push_back(0);
    std::erase_if(ends, [](double s) { return !(s >= 0); });
    std::sort(ends.begin(), ends.end());
    double sum = 0;
    for (std::size_t i = 1; i < ends.size(); ++i) {
      if (ends[i] - ends[i - 1] < 1e-14) continue;
      sum += inner.smooth(on_ray, ends[i - 1], ends[i], tolerance, {"the ray", angle}).value;
    }
    return sum;
  };
  angles.push_back(-std::numbers::pi);
  angles.push_back(std::numbers::pi);
  std::sort(angles.begin(), angles.end());
  double sum = 0;
  for (std::size_t i = 1; i < angles.size(); ++i) {
    if (angles[i] - angles[i - 1] < 1e-12) continue;
    sum +=
        outer.smooth(along_ray, angles[i - 1], angles[i], 10 * tolerance, {"the rays", at.norm()})
            .value;
  }
  return sum;
}

/// The same for a pressure that is linear or bilinear between these segments.
inline double polar_potential(
    const Pressure& pressure,
    const std::vector<std::pair<point_contact::Vector2, point_contact::Vector2>>& segments,
    const point_contact::Vector2& at) {
  std::vector<double> angles;
  for (const auto& [begin, end] : segments) {
    for (const point_contact::Vector2& corner : {begin, end}) {
      const point_contact::Vector2 d = corner - at;
      if (d.norm() > 0) angles.push_back(std::atan2(d.y(), d.x()));
    }
  }
  const Crossings crossings = [&](double angle) {
    const point_contact::Vector2 direction(std::cos(angle), std::sin(angle));
    std::vector<double> all;
    for (const auto& [begin, end] : segments) {
      const point_contact::Vector2 side = end - begin;
      const double denominator = point_contact::cross(direction, side);
      if (denominator == 0) continue;
      const point_contact::Vector2 d = begin - at;
      const double along_side = point_contact::cross(d, direction) / denominator;
      if (along_side < 0 || along_side > 1) continue;
      all.push_back(point_contact::cross(d, side) / denominator);
    }
    return all;
  };
  return polar_potential(pressure, crossings, angles, at);
}

/// The same for a pressure on the ellipse with these semi-axes.
inline double elliptic_potential(const Pressure& pressure, double a, double b,
                                 const point_contact::Vector2& at, double tolerance = 1e-11) {
  const double x = at.x() / a;
  const double y = at.y() / b;
  // in the plane stretched to the unit circle: |(x, y) + s (cos/a, sin/b)| = 1
  const auto discriminant = [=](double angle) {
    const double u = std::cos(angle) / a;
    const double v = std::sin(angle) / b;
    return u * u + v * v - std::pow(x * v - y * u, 2);
  };
  const Crossings crossings = [=](double angle) -> std::vector<double> {
    const double u = std::cos(angle) / a;
    const double v = std::sin(angle) / b;
    const double square = u * u + v * v;
    const double root = discriminant(angle);
    if (root <= 0) return {};
    return {(-(x * u + y * v) - std::sqrt(root)) / square,
            (-(x * u + y * v) + std::sqrt(root)) / square};
  };
  std::vector<double> angles;
  if (x * x + y * y > 1) {
    // the two tangents, as directions towards the points where they touch
    const double towards = std::atan2(-y, -x);
    const double half = std::asin(1 / std::hypot(x, y));
    for (const double side : {-half, half}) {
      const double u = std::cos(towards + side) * a;
      const double v = std::sin(towards + side) * b;
      angles.push_back(std::atan2(v, u));
    }
  }
  return polar_potential(pressure, crossings, angles, at, tolerance);
}

/// The same for a pressure p(r) on the disk r < a, at the distance rho from its middle.
inline double axial_potential(const std::function<double(double)>& pressure, double a, double rho,
                              double tolerance = 1e-11) {
  const double scale = pressure(a / 2);
  const Pressure scaled = [&](const point_contact::Vector2& s) {
    return s.norm() < 1 ? pressure(a * s.norm()) / scale : 0;
  };
  return scale * a * elliptic_potential(scaled, 1, 1, {rho / a, 0}, tolerance);
}
