// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/solver/grid.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <cmath>
#include <numbers>

#include "point_contact/solver/influence_operator.hpp"
#include "system/require.hpp"

namespace point_contact {
namespace {

double require_n(Eigen::Index n) {
  if (n < min_nodes) {
    throw sys::InvalidQuantity("nodes a side", static_cast<double>(n),
                               fmt::format("{} or more", min_nodes));
  }
  return static_cast<double>(n);
}

double bytes_of_machine() {
  return static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
}

}  // namespace

Grid rectangular_grid(double width, double height, Eigen::Index n) {
  sys::require_positive("domain width", width);
  sys::require_positive("domain height", height);
  const double count = require_n(n);
  return {{{width / count, 0}, {0, height / count}}, n, n};
}

Grid square_grid(double width, Eigen::Index n) {
  return rectangular_grid(width, width, n);
}

Grid hexagonal_grid(double width, Eigen::Index n, double stretch) {
  sys::require_positive("domain width", width);
  sys::require_positive("stretch", stretch);
  Lattice lattice = hexagonal_lattice(width / require_n(n));
  lattice.second.y() *= stretch;
  const double n_rows = std::ceil(static_cast<double>(n) * 2 / std::numbers::sqrt3);
  return {
      .lattice = lattice, .n1 = n, .n2 = static_cast<Eigen::Index>(n_rows), .is_staggered = true};
}

Grid Grid::with_nodes(Eigen::Index new_n1, Eigen::Index new_n2) const {
  Grid grid = *this;
  grid.n1 = new_n1;
  grid.n2 = new_n2;
  grid.lattice.first = lattice.first * (static_cast<double>(n1) / static_cast<double>(new_n1));
  grid.lattice.second = between_rows() * (static_cast<double>(n2) / static_cast<double>(new_n2));
  if (is_staggered) grid.lattice.second += grid.lattice.first / 2;
  return grid;
}

void require_memory(Eigen::Index n1, Eigen::Index n2) {
  // Nine fields of doubles, the mask of the contact, and as much as two fields in between.
  constexpr double bytes_of_fields = 9 * 8 + 1 + 16;
  const auto n_nodes = static_cast<double>(n1) * static_cast<double>(n2);
  constexpr double billions = 1e18;  // beyond, even the sizes are no numbers of the machine
  const double need = bytes_of_fields * n_nodes +
                      (n_nodes < billions ? InfluenceOperator::bytes(n1, n2) : 80 * n_nodes);
  if (need <= bytes_of_machine()) return;
  throw sys::InvalidQuantity(
      "nodes", n_nodes,
      fmt::format("fewer: these need {:.3g} GB of memory, and there are {:.3g} "
                  "GB",
                  1e-9 * need, 1e-9 * bytes_of_machine()));
}

}  // namespace point_contact
