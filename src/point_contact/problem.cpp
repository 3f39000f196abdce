// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/problem.hpp"

#include <fmt/core.h>
#include <gsl/gsl_interp2d.h>
#include <gsl/gsl_spline2d.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "contact/accuracy.hpp"
#include "system/require.hpp"

namespace point_contact {
namespace {

std::vector<double> coordinates(Eigen::Index n, double spacing) {
  std::vector<double> x;
  for (Eigen::Index i = 0; i < n; ++i) {
    x.push_back((static_cast<double>(i) - static_cast<double>(n - 1) / 2) * spacing);
  }
  return x;
}

void require_enough_points(std::string_view name, Eigen::Index n) {
  constexpr Eigen::Index fewest = 4;
  if (n >= fewest) return;
  throw sys::InvalidQuantity(name, static_cast<double>(n), fmt::format("{} or more", fewest));
}

}  // namespace

Profile Profile::paraboloid(double relative_curvature) {
  return elliptic_paraboloid(relative_curvature, relative_curvature);
}

Profile Profile::elliptic_paraboloid(double curvature_x, double curvature_y) {
  const double half_x = sys::require_positive("curvature_x", curvature_x) / 2;
  const double half_y = sys::require_positive("curvature_y", curvature_y) / 2;
  return Profile([=](double x, double y) { return half_x * x * x + half_y * y * y; });
}

Profile Profile::height_map(const Eigen::ArrayXXd& heights, double spacing) {
  sys::require_positive("spacing", spacing);
  require_enough_points("rows of heights", heights.rows());
  require_enough_points("columns of heights", heights.cols());
  for (Eigen::Index j = 0; j < heights.cols(); ++j) {
    for (Eigen::Index i = 0; i < heights.rows(); ++i) sys::require_finite("height", heights(i, j));
  }
  const std::vector<double> x = coordinates(heights.rows(), spacing);
  const std::vector<double> y = coordinates(heights.cols(), spacing);
  // GSL expects neighbours along x to be contiguous, as Eigen stores columns.
  const std::shared_ptr<gsl_spline2d> spline(
      gsl_spline2d_alloc(gsl_interp2d_bicubic, x.size(), y.size()), gsl_spline2d_free);
  gsl_spline2d_init(spline.get(), x.data(), y.data(), heights.data(), x.size(), y.size());
  Profile profile([spline](double at_x, double at_y) {
    return gsl_spline2d_eval(spline.get(), at_x, at_y, nullptr, nullptr);
  });
  profile.half_sides_ = {x.back(), y.back()};
  return profile;
}

Grid rectangular_grid(double width, double height, Eigen::Index n) {
  sys::require_positive("domain", width);
  sys::require_positive("domain", height);
  if (n < min_nodes || n > max_nodes) {
    throw sys::InvalidQuantity("nodes", static_cast<double>(n),
                               fmt::format("from {} to {}", min_nodes, max_nodes));
  }
  const double spacing = std::max(width, height) / static_cast<double>(n);
  const auto nodes_along = [&](double side) {
    constexpr double rounding = 1e-9;  // of a count
    return std::max(min_nodes, static_cast<Eigen::Index>(std::ceil(side / spacing - rounding)));
  };
  return {spacing, nodes_along(width), nodes_along(height)};
}

Grid square_grid(double width, Eigen::Index n) {
  return rectangular_grid(width, width, n);
}

Eigen::VectorXd initial_gaps(const Problem& problem) {
  sys::require_positive("contact_modulus", problem.contact_modulus);
  const Grid& grid = problem.grid;
  const Eigen::Index longer = std::max(grid.n1, grid.n2);
  if (std::min(grid.n1, grid.n2) < min_nodes || longer > max_nodes) {
    throw sys::InvalidQuantity("nodes", static_cast<double>(longer),
                               fmt::format("from {} to {}", min_nodes, max_nodes));
  }
  const Vector2 corner = grid.node(grid.n1 - 1, grid.n2 - 1);
  const Vector2& half_sides = problem.profile.half_sides();
  if (!(corner.array() <= half_sides.array()).all()) {
    throw sys::InvalidQuantity(
        "domain", static_cast<double>(grid.n1) * grid.spacing,
        fmt::format("within the measured surface, |x| ≤ {:.6g}, |y| ≤ {:.6g}; its corner is at "
                    "({:.6g}, {:.6g})",
                    half_sides.x(), half_sides.y(), corner.x(), corner.y()));
  }
  Eigen::VectorXd gaps(grid.size());
  for (Eigen::Index j = 0; j < grid.n2; ++j) {
    for (Eigen::Index i = 0; i < grid.n1; ++i) {
      gaps[grid.index(i, j)] = problem.profile.gap(grid.node(i, j));
    }
  }
  const double largest = gaps.cwiseAbs().maxCoeff();
  if (!(largest < contact::largest_length)) {
    throw sys::InvalidQuantity("largest gap on the grid", largest,
                               fmt::format("less than {}", contact::largest_length));
  }
  return gaps;
}

double total_phi(const Problem& problem, double load) {
  sys::require_positive("load", load);
  const double total = load / (std::numbers::pi * problem.contact_modulus * problem.grid.spacing);
  if (!(total < contact::largest_length)) {
    throw sys::InvalidQuantity(
        "load", load, fmt::format("less than {:.3g}", load / total * contact::largest_length));
  }
  return total;
}

}  // namespace point_contact
