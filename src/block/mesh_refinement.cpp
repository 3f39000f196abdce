// SPDX-License-Identifier: GPL-3.0-or-later
#include "block/mesh.hpp"

#include <cmath>
#include <cstddef>

namespace block {
namespace {

// Returns the distances of the boundaries from a graded end, of which the first is `smallest` and
// the last `length`.
std::vector<double> graded_distances(double smallest, double length, double ratio) {
  if (smallest >= length) return {length};
  const double exact = std::log(smallest / length) / std::log(ratio);
  // The end is taken a little before `length`, so that rounding does not add a layer to one of two
  // equal halves.
  const int n_layers = static_cast<int>(std::ceil(exact - 1e-9));
  std::vector<double> distances;
  for (int k = n_layers; k >= 0; --k) {
    distances.push_back(length * std::pow(smallest / length, static_cast<double>(k) / n_layers));
  }
  return distances;
}

}  // namespace

std::vector<double> graded_lines(const std::vector<GradedPoint>& points, double ratio) {
  std::vector<double> lines{points.front().position};
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const GradedPoint& begin = points[i];
    const GradedPoint& end = points[i + 1];
    const double half = (end.position - begin.position) / 2;

    // Grade the first half away from its end and the second towards its own; the boundary in the
    // middle belongs to both
    for (const double d : graded_distances(begin.smallest, half, ratio)) {
      lines.push_back(begin.position + d);
    }
    const std::vector<double> inwards = graded_distances(end.smallest, half, ratio);
    for (auto d = inwards.rbegin() + 1; d != inwards.rend(); ++d) {
      lines.push_back(end.position - *d);
    }
    lines.push_back(end.position);
  }
  return lines;
}

}  // namespace block
