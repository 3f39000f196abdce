// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace paper {

/// The fewest decimals, at most nine, that print every one of the points exactly.
int decimals_of(const std::vector<double>& points);

}  // namespace paper
