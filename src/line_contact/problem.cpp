// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_contact/problem.hpp"

#include <fmt/core.h>
#include <gsl/gsl_spline.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "contact/accuracy.hpp"
#include "system/require.hpp"

namespace line_contact {

Profile Profile::parabola(double relative_curvature) {
  const double half = sys::require_positive("relative_curvature", relative_curvature) / 2;
  return {[half](double x) { return half * x * x; },
          [half](double from, double to) { return half * (to - from) * (to + from); }};
}

Profile Profile::tabulated(const std::vector<double>& x, const std::vector<double>& gap) {
  constexpr std::size_t min_points = 4;
  if (x.size() < min_points || x.size() != gap.size()) {
    throw sys::InvalidQuantity("profile points", static_cast<double>(x.size()),
                               fmt::format("{} or more", min_points));
  }
  for (std::size_t i = 0; i < x.size(); ++i) {
    sys::require_finite("profile x", x[i]);
    sys::require_finite("profile gap", gap[i]);
    if (i > 0 && !(x[i] > x[i - 1])) {
      throw sys::InvalidQuantity("profile x", x[i],
                                 fmt::format("greater than the one before, {:.6g}", x[i - 1]));
    }
  }
  const std::shared_ptr<gsl_spline> spline(gsl_spline_alloc(gsl_interp_steffen, x.size()),
                                           gsl_spline_free);
  gsl_spline_init(spline.get(), x.data(), gap.data(), x.size());
  const auto height = [spline](double at) { return gsl_spline_eval(spline.get(), at, nullptr); };
  Profile profile(height, [height](double from, double to) { return height(to) - height(from); });
  profile.begin_ = x.front();
  profile.end_ = x.back();
  return profile;
}

namespace {

double require_n_nodes(Eigen::Index n_nodes) {
  if (n_nodes < min_nodes || n_nodes > max_nodes) {
    throw sys::InvalidQuantity("nodes", static_cast<double>(n_nodes),
                               fmt::format("from {} to {}", min_nodes, max_nodes));
  }
  return static_cast<double>(n_nodes);
}

}  // namespace

Eigen::VectorXd Grid::nodes() const {
  return Eigen::VectorXd::NullaryExpr(n_nodes, [this](Eigen::Index i) { return x(i); });
}

Grid grid_around(double half_width, Eigen::Index n_nodes) {
  sys::require_positive("half_width", half_width);
  constexpr double margin = 1.1;
  const double n_intervals_inside = require_n_nodes(n_nodes) - 3;
  return {n_nodes, 2 * margin * half_width / n_intervals_inside};
}

Grid grid_of_width(double width, Eigen::Index n_nodes, double centre) {
  sys::require_positive("domain", width);
  return {n_nodes, width / require_n_nodes(n_nodes), sys::require_finite("centre", centre)};
}

void require_valid(const Problem& problem) {
  sys::require_positive("contact_modulus", problem.contact_modulus);
  const Grid& grid = problem.grid;
  const Profile& profile = problem.profile;
  require_n_nodes(grid.n_nodes);
  if (grid.x(0) < profile.begin() || grid.x(grid.n_nodes - 1) > profile.end()) {
    throw sys::InvalidQuantity("domain", grid.width(),
                               fmt::format("within the profile's points, from {:.6g} to {:.6g}",
                                           profile.begin(), profile.end()));
  }
  double largest = 0;
  for (Eigen::Index i = 0; i < grid.n_nodes; ++i) {
    const double gap = profile.gap(grid.x(i));
    largest = std::max(largest, std::abs(gap));
    if (std::abs(gap) < contact::largest_length) continue;
    throw sys::InvalidQuantity(fmt::format("gap at x = {:.6g}", grid.x(i)), gap,
                               fmt::format("less than {}", contact::largest_length));
  }
  // The iterative methods square lengths; the squares must not underflow.
  constexpr double least_length = 1e-130;
  if (largest > 0 && largest < least_length) {
    throw sys::InvalidQuantity("largest gap on the grid", largest,
                               fmt::format("0 or at least {}", least_length));
  }
}

}  // namespace line_contact
