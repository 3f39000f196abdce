// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace app {

/// Two columns of a CSV file, as many numbers in each.
struct CsvColumns {
  std::vector<double> first;
  std::vector<double> second;
  std::vector<unsigned> lines;  ///< of the file, where each pair stands
};

/// Reads a CSV file whose heading names the two columns. Empty lines and lines that begin with #
/// are passed over. Throws sys::InputError naming file and line for a file that cannot be read, a
/// heading or line without both columns, or what is no number.
CsvColumns read_columns(const std::string& file, const std::string& first,
                        const std::string& second);

}  // namespace app
