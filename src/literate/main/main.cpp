// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/main/main.hpp"

#include <fmt/core.h>

#include "command_line/options.hpp"
#include "literate/main/stages.hpp"

namespace literate {

std::string version_text(const Paper& paper) {
  return fmt::format("{} {} (commit {}{})", paper.project, paper.version, paper.commit,
                     paper.modified ? ", modified" : "");
}

void add_stages(CLI::App& program, sys::ExitCode& exit_code, const Paper& paper,
                const Compute& compute) {
  add_compute_stage(program, exit_code, paper, compute);
  add_draw_stage(program, exit_code);
  add_typeset_stage(program, exit_code, paper);
  add_check_stage(program, exit_code);
  add_describe_stage(program, exit_code, paper);
}

int main(int argc, char** argv, const Paper& paper, const Compute& compute) {
  return command_line::run_program(
      {.name = paper.project,
       .description = "Computes, typesets and checks the paper " + paper.project + ".",
       .version = version_text(paper)},
      {[&](CLI::App& program, sys::ExitCode& exit_code) {
        add_stages(program, exit_code, paper, compute);
      }},
      argc, argv);
}

}  // namespace literate
