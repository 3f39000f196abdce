// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/main/main.hpp"

#include "command_line/options.hpp"
#include "literate/main/stages.hpp"

namespace literate {

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
