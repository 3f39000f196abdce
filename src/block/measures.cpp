// SPDX-License-Identifier: GPL-3.0-or-later
#include "block/measures.hpp"

#include <fmt/core.h>

#include <cmath>
#include <limits>

#include "system/require.hpp"

namespace block {
namespace {

// The value of the largest magnitude, with its sign. The two sides of a symmetric block agree but
// for rounding, and the value on the left is taken, so that the sign of an antisymmetric measure
// does not depend on rounding.
class SignedExtreme {
 public:
  void offer(double value, double x) {
    const double margin = 1e-6 * std::abs(value_);
    const double gain = std::abs(value) - std::abs(value_);
    if (gain > margin || (gain > -margin && x < x_)) {
      value_ = value;
      x_ = x;
    }
  }
  double value() const { return value_; }

 private:
  double value_ = 0;
  double x_ = std::numeric_limits<double>::infinity();
};

// The maxima over all points that were offered so far.
struct Maxima {
  double disp_mag = 0;
  SignedExtreme disp_x, disp_y;
  SignedExtreme stress_xx, stress_xy, stress_yy, stress_zz, prin_mag;
  double stress_prin = -std::numeric_limits<double>::infinity();
  double stress_prin_min = std::numeric_limits<double>::infinity();
  double stress_prin_regular = -std::numeric_limits<double>::infinity();
  double stress_vm = 0;

  void offer(const PointState& state, bool is_regular);
};

void Maxima::offer(const PointState& state, bool is_regular) {
  const double x = state.position.x();
  const Stress& s = state.stress;
  disp_mag = std::max(disp_mag, state.displacement.norm());
  disp_x.offer(state.displacement.x(), x);
  disp_y.offer(-state.displacement.y(), x);

  // Here z points down and y out of the plane; there y points up and z out of the plane. So the
  // shear changes its sign
  stress_xx.offer(s.xx, x);
  stress_xy.offer(-s.xz, x);
  stress_yy.offer(s.zz, x);
  stress_zz.offer(s.yy, x);
  stress_vm = std::max(stress_vm, von_mises(s));

  const auto principal = principal_stresses(s);
  stress_prin = std::max(stress_prin, principal.front());
  stress_prin_min = std::min(stress_prin_min, principal.back());
  prin_mag.offer(principal.front(), x);
  prin_mag.offer(principal.back(), x);
  if (is_regular) stress_prin_regular = std::max(stress_prin_regular, principal.front());
}

bool is_outside(const std::vector<Disc>& discs, const Eigen::Vector2d& position) {
  for (const Disc& disc : discs) {
    if (std::hypot(position.x() - disc.x, position.y() - disc.z) < disc.radius) return false;
  }
  return true;
}

Maxima maxima_of(const Solution& solution, const MeasureOptions& options) {
  Maxima maxima;
  const auto grid = Eigen::VectorXd::LinSpaced(options.plotting_grid + 1, -1, 1);
  for (Index e = 0; e < solution.model().mesh().n_elements(); ++e) {
    for (const PointState& state : solution.sample(e, grid)) {
      maxima.offer(state, is_outside(options.singular_discs, state.position));
    }
  }
  return maxima;
}

}  // namespace

std::vector<Measure> measures(const Solution& solution, const MeasureOptions& options) {
  if (options.plotting_grid < 1) {
    throw sys::InvalidQuantity("plotting_grid", options.plotting_grid, "1 or more");
  }
  const Maxima maxima = maxima_of(solution, options);
  const Resultant applied = solution.applied();
  std::vector<Measure> list{{"resultant_load_x", applied.force.x()},
                            {"resultant_load_y", -applied.force.y()},
                            {"max_disp_mag", maxima.disp_mag},
                            {"max_disp_x", maxima.disp_x.value()},
                            {"max_disp_y", maxima.disp_y.value()},
                            {"max_disp_z", 0},
                            {"max_prin_mag", maxima.prin_mag.value()},
                            {"max_rot_mag", 0},
                            {"max_rot_x", 0},
                            {"max_rot_y", 0},
                            {"max_rot_z", 0},
                            {"max_stress_prin", maxima.stress_prin},
                            {"max_stress_vm", maxima.stress_vm},
                            {"max_stress_xx", maxima.stress_xx.value()},
                            {"max_stress_xy", maxima.stress_xy.value()},
                            {"max_stress_xz", 0},
                            {"max_stress_yy", maxima.stress_yy.value()},
                            {"max_stress_yz", 0},
                            {"max_stress_zz", maxima.stress_zz.value()},
                            {"min_stress_prin", maxima.stress_prin_min},
                            {"strain_energy", solution.strain_energy()}};
  for (std::size_t i = 0; i < options.surface_points.size(); ++i) {
    const double u_z = solution.displacement(options.surface_points[i], 0).y();
    list.push_back({fmt::format("measure{}", i + 1), -u_z});
  }
  if (!options.singular_discs.empty()) {
    list.push_back({"max_stress_prin_regular", maxima.stress_prin_regular});
  }
  return list;
}

}  // namespace block
