// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_contact/profile.hpp"

#include <fmt/core.h>
#include <gsl/gsl_spline.h>

#include <algorithm>
#include <cmath>
#include <memory>

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

}  // namespace line_contact
