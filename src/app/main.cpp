// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/program.hpp"

int main(int argc, char** argv) {
  return app::run_program(argc, argv);
}
