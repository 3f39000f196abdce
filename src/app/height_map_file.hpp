// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <string>

namespace app {

/// A grid of numbers from a CSV file: a line for each y, rising, with a number for each x. The
/// result's entry (i, j) is the i-th number of the j-th line. Empty lines and lines that begin with
/// # are passed over. Throws sys::InputError naming file, line and column for a file that cannot be
/// read, a number that is none or missing, a line with more or fewer numbers than the first, and
/// fewer than four either way.
Eigen::ArrayXXd read_grid(const std::string& file);

}  // namespace app
