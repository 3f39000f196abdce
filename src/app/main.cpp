// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands.hpp"
#include "command_line/options.hpp"

int main(int argc, char** argv) {
  return command_line::run_program(
      "Surface displacements and contact of elastic half-spaces: Ruggiero (2001) rebuilt from its "
      "equations.",
      app::all_commands, argc, argv);
}
