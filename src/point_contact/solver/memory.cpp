// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/solver/problem.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include "point_contact/solver/influence_operator.hpp"
#include "system/require.hpp"

namespace point_contact {
namespace {

double bytes_of_machine() {
  return static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
}

}  // namespace

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
