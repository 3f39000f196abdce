// SPDX-License-Identifier: GPL-3.0-or-later
// program TASK: numbers on standard input, the answer on standard output.
#include <cstdio>
#include <iostream>
#include <iterator>
#include <string_view>
#include <vector>

#include "toy.hpp"

int main(int argc, char** argv) {
  const std::string_view task = argc == 2 ? argv[1] : "";
  const std::vector<double> inputs(std::istream_iterator<double>(std::cin), {});
  if (task == "square") {
    for (const double x : inputs) std::printf("%.17g\n", square(x));
  } else if (task == "sum") {
    std::printf("%.17g\n", sum(inputs));
  } else {
    return 2;
  }
}
