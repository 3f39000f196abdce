// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/solution.hpp"

#include <algorithm>
#include <cmath>

namespace contact {

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
