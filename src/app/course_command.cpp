// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands.hpp"
#include "app/course_commands.hpp"
#include "app/options.hpp"

namespace app {

void add_course_command(CLI::App& program, ExitCode& exit_code) {
  CLI::App& course =
      add_command_group(program, "course", "Make, release and grade the course assignment");
  add_course_release_commands(course, exit_code);
  add_course_grading_commands(course, exit_code);
  add_course_sheet_command(course, exit_code);
}

}  // namespace app
