// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/main/stages.hpp"

namespace literate {

void add_stages(CLI::App& program, sys::ExitCode& exit_code, const Paper& paper,
                const Compute& compute) {
  add_compute_stage(program, exit_code, paper, compute);
  add_draw_stage(program, exit_code);
  add_typeset_stage(program, exit_code, paper);
  add_check_stage(program, exit_code);
  add_restyle_stage(program, exit_code);
  add_page_stage(program, exit_code);
  add_describe_stage(program, exit_code, paper);
}

}  // namespace literate
