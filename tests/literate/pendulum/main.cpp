// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/main/main.hpp"
#include "pendulum/pendulum.hpp"

int main(int argc, char** argv) {
  return literate::main(argc, argv, pendulum::compute);
}
