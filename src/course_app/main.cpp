// SPDX-License-Identifier: GPL-3.0-or-later
#include "command_line/options.hpp"
#include "course_app/commands.hpp"
#include "literate/main/paper.hpp"

int main(int argc, char** argv) {
  return command_line::run_program(
      {.name = "halfspace-course",
       .description = "Makes, releases and grades the course assignment.",
       .version = literate::version_text(literate::this_paper())},
      {course_app::add_handout_command, course_app::add_solution_command,
       course_app::add_prove_command, course_app::add_check_variants_command,
       course_app::add_toolkit_command, course_app::add_grade_command, course_app::add_list_command,
       course_app::add_student_command, course_app::add_class_command,
       course_app::add_collect_command, course_app::add_likeness_command,
       course_app::add_marking_command, course_app::add_results_command,
       course_app::add_sheet_command, course_app::add_sheet_stages},
      argc, argv);
}
