// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include "block/exports.hpp"
#include "system/require.hpp"

namespace block {
namespace {

// Corners counter-clockwise as one sees them with y up; each row of points lies below the last.
std::vector<std::int64_t> corners_of(Index n_elements, Index n_cells) {
  const Index n_points = n_cells + 1;
  std::vector<std::int64_t> corners;
  for (Index e = 0; e < n_elements; ++e) {
    for (Index j = 0; j < n_cells; ++j) {
      for (Index i = 0; i < n_cells; ++i) {
        const Index above = (e * n_points + j) * n_points + i;
        const Index below = above + n_points;
        corners.insert(corners.end(), {below, below + 1, above + 1, above});
      }
    }
  }
  return corners;
}

}  // namespace

numerics::UnstructuredGrid sampled_grid(const Solution& solution, int n_cells) {
  if (n_cells > 100) throw sys::InvalidQuantity("n_cells", n_cells, "100 or less");
  const Mesh& mesh = solution.model().mesh();
  if (n_cells <= 0) n_cells = mesh.order();

  std::vector<double> points, displacement, stress, von_mises_stress;
  const auto add = [](std::vector<double>& to, std::initializer_list<double> components) {
    to.insert(to.end(), components);
  };
  const auto positions = Eigen::VectorXd::LinSpaced(n_cells + 1, -1, 1);
  for (Index e = 0; e < mesh.n_elements(); ++e) {
    for (const PointState& s : solution.sample(e, positions)) {
      add(points, {s.position.x(), 0.0 - s.position.y(), 0});  // y = −z, and no −0
      add(displacement, {s.displacement.x(), 0.0 - s.displacement.y(), 0});
      add(stress, {s.stress.xx, s.stress.zz, s.stress.yy, 0.0 - s.stress.xz, 0, 0});
      add(von_mises_stress, {von_mises(s.stress)});
    }
  }
  return {.points = std::move(points),
          .n_corners = 4,
          .corners = corners_of(mesh.n_elements(), n_cells),
          .fields = {{"von_mises", 1, std::move(von_mises_stress)},
                     {"displacement", 3, std::move(displacement)},
                     {"stress", 6, std::move(stress)}}};
}

}  // namespace block
