// SPDX-License-Identifier: GPL-3.0-or-later
// Measured profiles, loads and surfaces in CSV files. Empty lines and lines that begin with # are
// ignored. Every function throws sys::InputError with the file and the position of the error.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace app {

/// A function sampled at rising x.
struct CurvePoints {
  std::vector<double> x, y;
};

/// Reads two columns with a heading such as "x,gap": at least `fewest` points, with rising x.
CurvePoints read_curve(const std::string& file, const std::string& heading, std::size_t fewest);

/// Reads a grid of at least 4 by 4 numbers without a heading: grid(i, j) is number i of line j.
Eigen::ArrayXXd read_grid(const std::string& file);

}  // namespace app
