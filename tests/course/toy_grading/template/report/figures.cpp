// SPDX-License-Identifier: GPL-3.0-or-later
// figures DIR: the numbers and the curve of the report.
#include <fstream>
#include <string>

#include "toy.hpp"
#include "variant_of_this_handout.hpp"

int main(int, char** argv) {
  const std::string folder = argv[1];
  std::ofstream curve(folder + "/square.dat");
  for (int i = -4; i <= 4; ++i) curve << i << ' ' << square(i) << '\n';
  std::ofstream numbers(folder + "/numbers.tex");
  numbers << "\\newcommand*\\area{" << square(this_variant("side")) << "\\,m$^2$}\n";
  return curve && numbers ? 0 : 2;
}
