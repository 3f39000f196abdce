// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands.hpp"
#include "command_line/options.hpp"

int main(int argc, char** argv) {
  return command_line::run_program(
      "Surface displacements and contact of elastic half-spaces: Ruggiero (2001) rebuilt from its "
      "equations.",
      {app::add_displacement_command, app::add_block_command, app::add_contact_command,
       app::add_stress_command, app::add_report_command, app::add_typeset_command,
       app::add_check_report_command},
      argc, argv);
}
