// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/bodies/profile.hpp"

#include <fmt/core.h>
#include <gsl/gsl_interp2d.h>
#include <gsl/gsl_spline2d.h>

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

}  // namespace point_contact
