// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/accuracy.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "system/require.hpp"

namespace contact {
namespace {

// With this many nodes across, the second-order error is below half a per cent.
constexpr double enough_across = 20;

}  // namespace

double require_tolerance(double tolerance, double least) {
  constexpr double too_large = 0.01;
  if (!(tolerance >= least && tolerance <= too_large)) {
    throw sys::InvalidQuantity("tolerance", tolerance,
                               fmt::format("from {}, the rounding error, to {}", least, too_large));
  }
  return tolerance;
}

void require_resolved(const Resolution& resolution) {
  if (resolution.n_in_contact >= least_nodes_in_contact) return;
  const double finer = enough_across / std::max(resolution.n_across, 1.0);
  throw sys::InvalidQuantity(
      "number of nodes in contact", static_cast<double>(resolution.n_in_contact),
      fmt::format("{} or more: use at least {:.0f} nodes instead of {}, or a domain of {:.2g} or "
                  "less",
                  least_nodes_in_contact, finer * static_cast<double>(resolution.n_nodes),
                  resolution.n_nodes, resolution.domain / finer));
}

double relative_error(const Resolution& resolution) {
  constexpr double of_second_order = 1.6;
  return of_second_order / (resolution.n_across * resolution.n_across);
}

std::string resolution_warning(const Resolution& resolution) {
  if (resolution.n_across >= enough_across) return "";
  return fmt::format(
      "only {:.2g} nodes lie across the contact, so its width and peak pressure are accurate to "
      "about "
      "{:.1g} %; use more nodes or a narrower domain",
      resolution.n_across, 100 * relative_error(resolution));
}

Residuals residuals_of_gaps(const Eigen::VectorXd& pressure, const Eigen::VectorXd& gap) {
  Residuals residuals;
  for (Eigen::Index i = 0; i < gap.size(); ++i) {
    if (pressure[i] > 0) {
      residuals.gap = std::max(residuals.gap, std::abs(gap[i]));
    } else {
      residuals.separation = std::max(residuals.separation, -gap[i]);
    }
  }
  return residuals;
}

}  // namespace contact
