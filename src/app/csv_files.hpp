// SPDX-License-Identifier: GPL-3.0-or-later
// Measured profiles, loads and surfaces in CSV files. Lines that are empty or begin with # do not
// count. Every function throws sys::InputError naming the file and the place of what is wrong in
// it.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace app {

/// A function at rising places.
struct CurvePoints {
  std::vector<double> x, y;
};

/// Reads two columns with the heading "x,gap" or the like: `fewest` points or more, and x rises.
CurvePoints read_curve(const std::string& file, const std::string& heading, std::size_t fewest);

/// Reads a grid of at least 4 by 4 numbers without a heading: grid(i, j) is number i of line j.
Eigen::ArrayXXd read_grid(const std::string& file);

/// Reads the numbers of a file, one or more on each line; "-" is standard input.
std::vector<double> read_numbers(const std::string& file);

}  // namespace app
