// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/solver/solution.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "point_contact/solver/grid.hpp"

namespace point_contact {
namespace {

using Eigen::Index;

constexpr std::array<std::pair<Index, Index>, 6> directions = {
    {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {-1, 1}, {1, -1}}};

// Goes through the region of one node in contact, and takes its nodes from `to_visit`.
Region region_around(const Solution& solution, Index first, std::vector<bool>& to_visit) {
  const Grid& grid = solution.grid;
  Region region{Vector2::Zero(), 0, 0, 0};
  std::vector<Index> open{first};
  to_visit[size_of(first)] = false;
  while (!open.empty()) {
    const Index node = open.back();
    open.pop_back();
    const Index i = node % grid.n1;
    const Index j = node / grid.n1;
    region.load += solution.pressure[node];
    region.centre += solution.pressure[node] * grid.node(i, j);
    ++region.n_nodes;
    for (const auto& [di, dj] : directions) {
      const Index row = j + dj;
      if (row < 0 || row >= grid.n2) continue;
      const Index column = grid.neighbour(i, j, di, dj);
      if (column < 0 || column >= grid.n1) continue;
      const Index next = grid.index(column, row);
      if (!to_visit[size_of(next)]) continue;
      to_visit[size_of(next)] = false;
      open.push_back(next);
    }
  }
  region.centre /= region.load;
  region.area = static_cast<double>(region.n_nodes) * grid.lattice.cell_area();
  region.load *= grid.lattice.cell_area();
  return region;
}

}  // namespace

std::vector<Region> regions(const Solution& solution) {
  const Index n = solution.pressure.size();
  std::vector<bool> to_visit(size_of(n));
  for (Index node = 0; node < n; ++node) to_visit[size_of(node)] = solution.pressure[node] > 0;
  std::vector<Region> found;
  for (Index node = 0; node < n; ++node) {
    if (to_visit[size_of(node)]) found.push_back(region_around(solution, node, to_visit));
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const Region& a, const Region& b) { return a.load > b.load; });
  return found;
}

}  // namespace point_contact
