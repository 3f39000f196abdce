// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands.hpp"
#include "literate/main/paper.hpp"

int main(int argc, char** argv) {
  return command_line::run_program(
      {.name = "halfspace",
       .description = "Surface displacements and contact of elastic half-spaces: Ruggiero (2001) "
                      "rebuilt from its equations.",
       .version = literate::version_text({.project = "halfspace",
                                          .version = HALFSPACE_VERSION,
                                          .repository = "generated/report/repository"})},
      app::all_commands, argc, argv);
}
