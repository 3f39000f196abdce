// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers that a user has in a CSV file. Both readers pass over empty lines and those that begin
// with #, and throw sys::InputError naming file and line for what is wrong in it.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace app {

/// Two columns of a CSV file, as many numbers in each.
struct CsvColumns {
  std::vector<double> first;
  std::vector<double> second;
  std::vector<unsigned> lines;  ///< of the file, where each pair stands
};

/// Reads a CSV file whose heading names the two columns. Wrong are a file that cannot be read, a
/// heading or line without both columns, and what is no number.
CsvColumns read_columns(const std::string& file, const std::string& first,
                        const std::string& second);

/// As read_columns(), of a curve: wrong besides are numbers of the first column that do not rise,
/// and fewer than so many points.
CsvColumns read_curve(const std::string& file, const std::string& first, const std::string& second,
                      std::size_t fewest);

/// A grid of numbers from a CSV file: a line for each y, rising, with a number for each x. The
/// result's entry (i, j) is the i-th number of the j-th line. Wrong are a file that cannot be read,
/// a number that is none or missing, whose column is named too, a line with more or fewer numbers
/// than the first, and fewer than four either way.
Eigen::ArrayXXd read_grid(const std::string& file);

}  // namespace app
