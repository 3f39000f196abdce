// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include "app/commands.hpp"
#include "app/options.hpp"
#include "toolchain/build_info.hpp"

int main(int argc, char** argv) {
  const app::ProgramText text{
      "halfspace",
      "Surface displacements and contact of elastic half-spaces: Ruggiero (2001) rebuilt from its "
      "equations.",
      fmt::format("halfspace {} (commit {}{})", toolchain::version, toolchain::commit,
                  toolchain::modified ? ", modified" : "")};
  return app::run_program(
      text,
      {app::add_displacement_command, app::add_block_command, app::add_contact_command,
       app::add_stress_command, app::add_report_command, app::add_typeset_command,
       app::add_describe_command, app::add_check_report_command, app::add_course_command},
      argc, argv);
}
