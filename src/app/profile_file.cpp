// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/profile_file.hpp"

#include <fmt/core.h>

#include "app/csv_columns.hpp"
#include "command_line/number_text.hpp"

namespace app {

contact::Profile read_profile(const std::string& file) {
  const CsvColumns points = read_columns(file, "x", "gap");
  const std::vector<double>& x = points.first;
  for (std::size_t i = 1; i < x.size(); ++i) {
    if (x[i] > x[i - 1]) continue;
    throw sys::InputError(fmt::format("{}:{}: x = {}: must be greater than the one before, {}",
                                      file, points.lines[i], command_line::shortest(x[i]),
                                      command_line::shortest(x[i - 1])));
  }
  constexpr std::size_t min_points = 4;
  if (x.size() < min_points) {
    throw sys::InputError(
        fmt::format("{}: holds {} points, {} or more are needed", file, x.size(), min_points));
  }
  return contact::Profile::tabulated(x, points.second);
}

}  // namespace app
