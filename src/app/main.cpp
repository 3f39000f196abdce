// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands.hpp"
#include "command_line/options.hpp"
#include "literate/main/paper.hpp"

int main(int argc, char** argv) {
  return command_line::run_program(
      {.name = "halfspace",
       .description = "Surface displacements and contact of elastic half-spaces: Ruggiero (2001) "
                      "rebuilt from its equations.",
       .version = literate::version_text(literate::this_paper())},
      {app::add_displacement_command, app::add_block_command, app::add_contact_command,
       app::add_stress_command, app::add_report_stages},
      argc, argv);
}
