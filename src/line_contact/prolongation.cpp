// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_contact/nested_grids.hpp"

#include <algorithm>
#include <cmath>

#include "line_contact/solution.hpp"

namespace line_contact {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// Interpolates between nodes i and i+1, both in contact, at the fraction t of the way.
double between(const VectorXd& p, Index i, double t) {
  const bool is_inside = i > 0 && i + 2 < p.size() && p[i - 1] > 0 && p[i + 2] > 0;
  if (!is_inside) return p[i] + t * (p[i + 1] - p[i]);
  const double linear = p[i] + t * (p[i + 1] - p[i]);
  const double left = p[i - 1] - 2 * p[i] + p[i + 1];
  const double right = p[i] - 2 * p[i + 1] + p[i + 2];
  return linear - t * (1 - t) / 6 * ((2 - t) * left + (1 + t) * right);
}

// A region of the coarse grid: its edges, and its first and last node.
struct Stretch {
  double begin, end;
  Index first, last;
};

// The square root of the fraction of the way from the edge to the end node; 1 if they coincide.
double rise_from_edge(double way, double whole) {
  return whole > 0 ? std::sqrt(std::clamp(way / whole, 0.0, 1.0)) : 1;
}

double pressure_at(const Grid& coarse, const VectorXd& p, const Stretch& stretch, double x) {
  const double position = (x - coarse.x(0)) / coarse.spacing;
  if (position < static_cast<double>(stretch.first)) {
    const double end_node = coarse.x(stretch.first);
    return p[stretch.first] * rise_from_edge(x - stretch.begin, end_node - stretch.begin);
  }
  if (position >= static_cast<double>(stretch.last)) {
    const double end_node = coarse.x(stretch.last);
    return p[stretch.last] * rise_from_edge(stretch.end - x, stretch.end - end_node);
  }
  const auto i = static_cast<Index>(position);
  return between(p, i, position - static_cast<double>(i));
}

}  // namespace

VectorXd prolongate(const Grid& coarse, const VectorXd& pressure, const Grid& fine) {
  VectorXd result = VectorXd::Zero(fine.n_nodes);
  for (const Region& region : regions_in_contact(coarse, pressure)) {
    const double middle = (region.begin + region.end) / 2;
    auto first = static_cast<Index>(std::lround((middle - coarse.x(0)) / coarse.spacing));
    first = std::clamp<Index>(first, 0, coarse.n_nodes - 1);
    Index last = first;
    while (first > 0 && pressure[first - 1] > 0) --first;
    while (last + 1 < coarse.n_nodes && pressure[last + 1] > 0) ++last;
    const Stretch stretch{region.begin, region.end, first, last};

    const auto index_at = [&](double x) { return (x - fine.x(0)) / fine.spacing; };
    const auto from = static_cast<Index>(std::ceil(std::max(0.0, index_at(region.begin))));
    const auto to = static_cast<Index>(
        std::floor(std::min(static_cast<double>(fine.n_nodes - 1), index_at(region.end))));
    for (Index i = from; i <= to; ++i)
      result[i] = pressure_at(coarse, pressure, stretch, fine.x(i));
  }
  return result;
}

}  // namespace line_contact
