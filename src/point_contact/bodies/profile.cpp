// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/bodies/profile.hpp"

#include <fmt/core.h>
#include <gsl/gsl_interp2d.h>
#include <gsl/gsl_spline2d.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

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

Profile Profile::cone(double slope) {
  sys::require_positive("slope", slope);
  return Profile([slope](double x, double y) { return slope * std::hypot(x, y); });
}

Profile Profile::flat_punch(double radius) {
  sys::require_positive("radius", radius);
  return Profile([radius](double x, double y) {
    return std::hypot(x, y) <= radius ? 0 : std::numeric_limits<double>::infinity();
  });
}

Profile Profile::rounded_punch(double flat_radius, double edge_curvature) {
  const double b = sys::require_finite("flat_radius", flat_radius);
  if (b < 0) throw sys::InvalidQuantity("flat_radius", b, "0 or greater");
  const double half = sys::require_positive("edge_curvature", edge_curvature) / 2;
  return Profile([=](double x, double y) {
    const double beyond = std::max(0.0, std::hypot(x, y) - b);
    return half * beyond * beyond;
  });
}

Profile Profile::power_law(double coefficient, int n) {
  sys::require_positive("coefficient", coefficient);
  if (n < 1 || n > max_power) {
    throw sys::InvalidQuantity("n", n, fmt::format("from 1 to {}", max_power));
  }
  return Profile([=](double x, double y) { return coefficient * std::pow(x * x + y * y, n); });
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
  // GSL wants the values of x next to each other, as Eigen stores columns.
  const std::shared_ptr<gsl_spline2d> spline(
      gsl_spline2d_alloc(gsl_interp2d_bicubic, x.size(), y.size()), gsl_spline2d_free);
  gsl_spline2d_init(spline.get(), x.data(), y.data(), heights.data(), x.size(), y.size());
  Profile profile([spline](double at_x, double at_y) {
    return gsl_spline2d_eval(spline.get(), at_x, at_y, nullptr, nullptr);
  });
  profile.half_sides_ = {x.back(), y.back()};
  return profile;
}

}  // namespace point_contact
