// SPDX-License-Identifier: GPL-3.0-or-later
#include "block/discretization.hpp"

#include <algorithm>
#include <cmath>

#include "block/mesh.hpp"
#include "block/nodal_forces.hpp"
#include "system/require.hpp"

namespace block {
namespace {

// Two kinks that are closer than this part of the width are one kink, which rounding or a change of
// units set apart.
constexpr double same_place = 1e-9;

// Returns the kinks, each with the size of the elements beside it, and the sides of the block on
// the left and right of them.
std::vector<GradedPoint> graded_columns(const Rectangle& block, const std::vector<double>& kinks,
                                        double fraction) {
  const double corner = fraction * block.width();
  std::vector<GradedPoint> points;
  for (std::size_t i = 0; i < kinks.size(); ++i) {
    double spacing = block.width();
    if (i > 0) spacing = std::min(spacing, kinks[i] - kinks[i - 1]);
    if (i + 1 < kinks.size()) spacing = std::min(spacing, kinks[i + 1] - kinks[i]);
    points.push_back({kinks[i], fraction * spacing});
  }

  // The outermost points are the sides; a kink within rounding of a side is moved onto it
  const double hair = same_place * block.width();
  if (kinks.front() - block.left() > hair) points.insert(points.begin(), {block.left(), corner});
  if (block.right() - kinks.back() > hair) points.push_back({block.right(), corner});
  points.front().position = block.left();
  points.back().position = block.right();
  return points;
}

}  // namespace

void require_valid(const Discretization& discretization) {
  if (discretization.order < 2 || discretization.order > 10) {
    throw sys::InvalidQuantity("order", discretization.order, "2 to 10");
  }
  if (discretization.refine < 0 || discretization.refine > 6) {
    throw sys::InvalidQuantity("refine", discretization.refine, "0 to 6");
  }
  sys::require_positive("max_megabytes", discretization.max_megabytes);
}

Discretization coarser(const Discretization& discretization) {
  Discretization result = discretization;
  result.order -= 1;
  result.refine = std::max(0, discretization.refine - 1);
  return result;
}

std::vector<double> kinks_of(const std::vector<elasticity::Load>& loads) {
  std::vector<double> kinks;
  for (const elasticity::Load& load : loads) {
    for (const auto* traction : {&load.normal, &load.tangential}) {
      for (const numerics::Piece& piece : traction->pieces()) {
        kinks.insert(kinks.end(), {piece.begin, piece.end});
      }
    }
  }
  std::sort(kinks.begin(), kinks.end());
  if (kinks.empty()) return kinks;
  const double hair = same_place * (kinks.back() - kinks.front());
  const auto is_same = [hair](double kink, double next) { return next - kink <= hair; };
  kinks.erase(std::unique(kinks.begin(), kinks.end(), is_same), kinks.end());
  return kinks;
}

Mesh graded_mesh(const Rectangle& block, const std::vector<elasticity::Load>& loads,
                 const Discretization& discretization) {
  for (const elasticity::Load& load : loads) require_inside(load, block.left(), block.right());
  const std::vector<double> kinks = kinks_of(loads);
  if (kinks.empty()) {
    throw sys::InvalidQuantity("number of loads", static_cast<double>(loads.size()),
                               "1 or more, with a traction that is not zero");
  }

  const double fraction = 0.2 * std::pow(0.3, discretization.refine);
  const double ratio = 0.2 + 0.07 * discretization.refine;
  const std::vector<GradedPoint> columns = graded_columns(block, kinks, fraction);
  double smallest = fraction * block.height();
  for (const GradedPoint& column : columns) smallest = std::min(smallest, column.smallest);
  return {discretization.order, graded_lines(columns, ratio),
          graded_lines({{0, smallest}, {block.height(), fraction * block.height()}}, ratio)};
}

}  // namespace block
