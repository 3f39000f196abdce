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

Profile Profile::wedge(double slope) {
  sys::require_positive("slope", slope);
  return {[slope](double x) { return slope * std::abs(x); },
          [slope](double from, double to) { return slope * (std::abs(to) - std::abs(from)); }};
}

Profile Profile::rounded_punch(double flat_half_width, double edge_curvature) {
  const double b = sys::require_finite("flat_half_width", flat_half_width);
  if (b < 0) throw sys::InvalidQuantity("flat_half_width", b, "0 or greater");
  const double half = sys::require_positive("edge_curvature", edge_curvature) / 2;
  const auto beyond = [b](double x) { return std::max(0.0, std::abs(x) - b); };
  return {[=](double x) { return half * beyond(x) * beyond(x); },
          [=](double from, double to) {
            const double f = beyond(from);
            const double t = beyond(to);
            const double step = f > 0 && t > 0 ? std::abs(to) - std::abs(from) : t - f;
            return half * step * (t + f);
          }};
}

Profile Profile::power_law(double coefficient, int n) {
  sys::require_positive("coefficient", coefficient);
  if (n < 1 || n > max_power) {
    throw sys::InvalidQuantity("n", n, fmt::format("from 1 to {}", max_power));
  }
  // tⁿ − fⁿ = (t − f) Σ t^k f^{n−1−k} with t = to², f = from²
  const auto rise = [=](double from, double to) {
    const double f = from * from;
    const double t = to * to;
    double sum = 0;
    for (int k = 0; k < n; ++k) sum = sum * f + std::pow(t, k);
    return coefficient * (to - from) * (to + from) * sum;
  };
  return {[=](double x) { return coefficient * std::pow(x * x, n); }, rise};
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
                                 fmt::format("greater than the one before, {}", x[i - 1]));
    }
  }
  const std::shared_ptr<gsl_spline> spline(gsl_spline_alloc(gsl_interp_steffen, x.size()),
                                           gsl_spline_free);
  gsl_spline_init(spline.get(), x.data(), gap.data(), x.size());
  const auto height = [spline](double at) { return gsl_spline_eval(spline.get(), at, nullptr); };
  Profile profile(height, [height](double from, double to) { return height(to) - height(from); });
  profile.is_symmetric_ = false;
  profile.begin_ = x.front();
  profile.end_ = x.back();
  return profile;
}

}  // namespace line_contact
