// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/spheres.hpp"

#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "paper/prelude.hpp"
#include "point_contact/elements/element.hpp"

namespace paper {

using point_contact::Vector2;

void draw_pyramid(Figure& figure) {
  const point_contact::Lattice lattice = point_contact::hexagonal_lattice(1);
  const auto at = [&](int i, int j) -> Vector2 {
    return static_cast<double>(i) * lattice.first + static_cast<double>(j) * lattice.second;
  };
  using Lines = std::array<std::vector<double>, 3>;
  const auto add = [](Lines& lines, const Vector2& begin, double z1, const Vector2& end,
                      double z2) {
    for (const auto& [p, z] : {std::pair{begin, z1}, {end, z2}}) {
      lines[0].push_back(p.x());
      lines[1].push_back(p.y());
      lines[2].push_back(z);
    }
  };
  Lines base;
  constexpr int n = 2;
  for (int i = -n; i <= n; ++i) {
    for (int j = -n; j <= n; ++j) {
      if (std::abs(i + j) > n) continue;
      for (const auto& [di, dj] : {std::pair{1, 0}, {0, 1}, {-1, 1}}) {
        const int i2 = i + di;
        const int j2 = j + dj;
        if (std::max({std::abs(i2), std::abs(j2), std::abs(i2 + j2)}) > n) continue;
        add(base, at(i, j), 0, at(i2, j2), 0);
      }
    }
  }
  constexpr std::array<std::array<int, 2>, 6> ring = {
      {{1, 0}, {0, 1}, {-1, 1}, {-1, 0}, {0, -1}, {1, -1}}};
  const auto pyramid = [&](int i, int j) {
    Lines lines;
    for (std::size_t k = 0; k < 6; ++k) {
      const Vector2 one = at(i + ring[k][0], j + ring[k][1]);
      const Vector2 next = at(i + ring[(k + 1) % 6][0], j + ring[(k + 1) % 6][1]);
      add(lines, one, 0, next, 0);
      add(lines, one, 0, at(i, j), 1);
    }
    return lines;
  };
  const auto data = [](const Lines& lines) {
    return FigureData({{"x", lines[0]}, {"y", lines[1]}, {"z", lines[2]}}, 2);
  };

  figure.data["base"] = data(base);
  figure.data["pyramid"] = data(pyramid(0, 0));
  figure.data["neighbour"] = data(pyramid(1, 0));
}

}  // namespace paper
