// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/validity.hpp"

#include <fmt/core.h>

#include <cstdio>

#include "command_line/exit_codes.hpp"

namespace app {

std::vector<std::string> half_space_warnings(double half_width, double least_radius) {
  if (!(least_radius > 0 && half_width > small_ratio * least_radius)) return {};
  return {fmt::format(
      "the contact's half-width is {:.2g} of the least radius: half-spaces stand for bodies whose "
      "contact is less than {} of it",
      half_width / least_radius, small_ratio)};
}

void print_warnings(const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) {
    fmt::print(stderr, "{}: warning: {}\n", command_line::program_name(), warning);
  }
}

}  // namespace app
