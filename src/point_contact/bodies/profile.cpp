// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/bodies/profile.hpp"

#include <fmt/core.h>
#include <gsl/gsl_interp2d.h>
#include <gsl/gsl_spline2d.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <memory>
#include <numbers>
#include <random>
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

void require(const Roughness& roughness, Eigen::Index n) {
  sys::require_positive("rms", roughness.rms);
  if (roughness.n_waves < 1 || roughness.n_waves > max_waves) {
    throw sys::InvalidQuantity("waves", roughness.n_waves, "from 1 to 64");
  }
  if (!(roughness.hurst >= 0 && roughness.hurst <= 1)) {
    throw sys::InvalidQuantity("hurst", roughness.hurst, "from 0 to 1");
  }
  if (n < 2)
    throw sys::InvalidQuantity("points along a side", static_cast<double>(n), "at least 2");
}

}  // namespace

RelativeCurvatures relative_curvatures(PrincipalCurvatures body1, PrincipalCurvatures body2,
                                       double angle) {
  sys::require_finite("angle", angle);
  const double sum = body1.first + body1.second + body2.first + body2.second;
  if (!(std::isfinite(sum) && sum > 0)) {
    throw sys::InvalidQuantity("sum of the curvatures", sum,
                               "greater than 0, or the bodies do not touch at a point");
  }
  // h = Σ/4 r² + ¼ Re[(Δ₁ + Δ₂ e^{2iα}) e^{−2iθ}] r², least where the bracket's phase is opposite
  const std::complex<double> difference =
      body1.first - body1.second + (body2.first - body2.second) * std::polar(1.0, 2 * angle);
  const double smaller = (sum - std::abs(difference)) / 2;
  const double rounding = 1e-15 * (std::abs(body1.first) + std::abs(body1.second) +
                                   std::abs(body2.first) + std::abs(body2.second));
  if (!(smaller > rounding)) {
    throw sys::InvalidQuantity("least relative curvature", smaller,
                               "greater than 0, or the bodies do not touch at a point alone");
  }
  const double phase = difference == 0.0 ? 0 : std::arg(-difference) / 2;
  return {smaller, (sum + std::abs(difference)) / 2, phase};
}

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

Eigen::ArrayXXd rough_heights(const Roughness& roughness, Eigen::Index n) {
  require(roughness, n);
  const int most = roughness.n_waves;
  // e^{2πikx} at the points, a column for each k from 0 on.
  Eigen::ArrayXXcd waves(n, most + 1);
  for (int k = 0; k <= most; ++k) {
    for (Eigen::Index i = 0; i < n; ++i) {
      const double turns = static_cast<double>(k * i) / static_cast<double>(n - 1);
      waves(i, k) = std::polar(1.0, 2 * std::numbers::pi * turns);
    }
  }

  std::mt19937_64 random(roughness.seed);
  constexpr double random_range = 18446744073709551616.0;  // 2⁶⁴
  Eigen::ArrayXXcd sum = Eigen::ArrayXXcd::Zero(n, n);
  double square = 0;  // of the heights, in the mean
  for (int l = 0; l <= most; ++l) {
    Eigen::ArrayXcd of_row = Eigen::ArrayXcd::Zero(n);  // Σ over k at this l
    for (int k = l == 0 ? 1 : -most; k <= most; ++k) {
      const double q = std::hypot(k, l);
      if (q > most) continue;
      const double height = std::pow(q, -1 - roughness.hurst);
      const double phase = 2 * std::numbers::pi * (static_cast<double>(random()) / random_range);
      const auto along = waves.col(std::abs(k));
      const std::complex<double> amplitude = std::polar(height, phase);
      if (k < 0) {
        of_row += amplitude * along.conjugate();
      } else {
        of_row += amplitude * along;
      }
      square += height * height / 2;
    }
    sum += (of_row.matrix() * waves.col(l).matrix().transpose()).array();
  }
  return roughness.rms / std::sqrt(square) * sum.real();
}

}  // namespace point_contact
