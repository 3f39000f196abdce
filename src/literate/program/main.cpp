// SPDX-License-Identifier: GPL-3.0-or-later
#include "command_line/options.hpp"
#include "literate/program/commands.hpp"

int main(int argc, char** argv) {
  return command_line::run_program(
      {.name = "literate",
       .description = "Papers whose numbers, tables, figures and claims come from their program.",
       .version = "literate " LITERATE_VERSION},
      {literate::add_new_command, literate::add_excerpts_command, literate::add_changes_command},
      argc, argv);
}
